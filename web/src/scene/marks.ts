// What stands over the path: numbers at red dots, start and end, labels of the grid, the axes, the
// scale, measured points.

import { t } from '../i18n.ts';
import type { Vector } from './camera.ts';
import { css } from './colours.ts';
import { placeLabels, roundStep, type GridLabel } from './grid.ts';
import type { View } from './view.ts';

export interface MeasurePoint {
  index: number;
  point: Vector;
}

/** More numbers and highlighted lines than these wait until the picture rests. */
const MANY = 3000;

type Box = [number, number, number, number];

/** A number at a red dot, with its place. */
export interface Numbered {
  text: string;
  x: number;
  y: number;
  box: Box;
}

/** The numbers of dots that stand so near that their texts would cover each other. */
export interface Numbers {
  x: number;
  y: number;
  first: number;
  last: number;
  /** Of how many dots. */
  count: number;
}

/** The text for numbers of dots. */
export function said({ first, last, count }: Numbers): string {
  return first !== last ? `N${first}…N${last}` : count > 1 ? `N${first} ×${count}` : `N${first}`;
}

/** Joins numbers whose texts cover each other until none does; `box` gives the place of a text. */
export function joined(numbers: Numbers[], box: (number: Numbers) => Box): Numbers[] {
  for (;;) {
    const kept: Numbers[] = [];
    // By squares of the canvas: which of the kept ones reach into it.
    const squares = new Map<string, Set<Numbers>>();
    for (const number of numbers) {
      const area = box(number);
      const near = squaresOf(area).flatMap((square) => [...(squares.get(square) ?? [])]);
      let place = near.find((other) => cover(box(other), area));
      if (place === undefined) {
        place = { ...number };
        kept.push(place);
      } else {
        place.last = number.last;
        place.count += number.count;
      }
      for (const square of squaresOf(box(place))) {
        const reaching = squares.get(square) ?? new Set();
        squares.set(square, reaching.add(place));
      }
    }
    if (kept.length === numbers.length) {
      return kept;
    }
    numbers = kept;
  }
}

/** Side of the squares, in CSS pixels. */
const SQUARE = 40;

function squaresOf([left, top, right, bottom]: Box): string[] {
  const squares: string[] = [];
  for (let column = Math.floor(left / SQUARE); column <= right / SQUARE; column += 1) {
    for (let row = Math.floor(top / SQUARE); row <= bottom / SQUARE; row += 1) {
      squares.push(`${column} ${row}`);
    }
  }
  return squares;
}

function cover(a: Box, b: Box): boolean {
  return a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
}

/** Texts that do not cover one another. */
class Labels {
  readonly #context: CanvasRenderingContext2D;
  readonly #taken: Box[] = [];

  constructor(context: CanvasRenderingContext2D) {
    this.#context = context;
  }

  /** Takes a box, whether it is free or not. */
  block(box: Box): void {
    this.#taken.push(box);
  }

  /** Whether a box is free; it is taken then. */
  take(box: Box): boolean {
    const covers = this.#taken.some(([a, b, c, d]) => box[0] < c && a < box[2] && box[1] < d && b < box[3]);
    if (!covers) {
      this.#taken.push(box);
    }
    return !covers;
  }

  box(text: string, x: number, y: number): Box {
    const width = this.#context.measureText(text).width;
    return [x - 2, y - 11, x + width + 2, y + 4];
  }

  draw(text: string, x: number, y: number, ink: string, halo: string): void {
    const context = this.#context;
    context.lineWidth = 3;
    context.strokeStyle = halo;
    context.strokeText(text, x, y);
    context.fillStyle = ink;
    context.fillText(text, x, y);
  }
}

export function drawMarks(view: View, canvas: HTMLCanvasElement, gridLabels: GridLabel[]): void {
  const context = canvas.getContext('2d')!;
  const ratio = canvas.width / Math.max(view.camera.width, 1);
  const { camera, theme, app } = view;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, camera.width, camera.height);
  context.lineJoin = 'round';
  context.lineCap = 'round';
  context.font = '11px system-ui, sans-serif';
  const background = css(theme.background);
  drawTogether(view, context);
  const labels = new Labels(context);
  labels.take([0, camera.height - 70, 76, camera.height]);
  labels.take([camera.width - 150, camera.height - 34, camera.width, camera.height]);
  if (app.shown.numbers && app.shown.red) {
    const placed = view.numbered !== undefined;
    view.numbered ??= placeNumbers(view, labels);
    for (const { text, x, y, box } of view.numbered) {
      if (placed) {
        labels.block(box);
      }
      labels.draw(text, x, y, theme.ink, background);
    }
  }
  drawEnds(view, context, labels, background);
  for (const { text, x, y } of placeLabels(gridLabels, camera, (text) => context.measureText(text).width)) {
    if (labels.take(labels.box(text, x, y))) {
      labels.draw(text, x, y, theme.faint, background);
    }
  }
  drawMeasured(view, context, labels, background);
  if (view.app.path.rows.length > 0) {
    drawAxes(view, context);
    drawScale(view, context);
  }
}

/** All executions of the block in hand, fainter than the one that is. */
function drawTogether(view: View, context: CanvasRenderingContext2D): void {
  const { app, camera, theme } = view;
  const { path } = app;
  if (app.together.length < 2 || (view.isMoving && app.together.length > MANY)) {
    return;
  }
  context.beginPath();
  for (const row of app.together) {
    if (!path.hasLine(row)) {
      const { x, y } = camera.project(path.point(row));
      context.moveTo(x + 4, y);
      context.arc(x, y, 4, 0, 2 * Math.PI);
      continue;
    }
    const parts = path.isArc(row) ? Math.min(path.chords(row, 0.3 / camera.scale), 360) : 1;
    for (let part = 0; part <= parts; part += 1) {
      const { x, y } = camera.project(path.at(row, part / parts));
      if (part === 0) {
        context.moveTo(x, y);
      } else {
        context.lineTo(x, y);
      }
    }
  }
  context.globalAlpha = 0.55;
  context.lineWidth = 3;
  context.strokeStyle = theme.selection;
  context.stroke();
  context.globalAlpha = 1;
}

/** The numbers at red dots; those that would cover each other stand once, as in still pictures. */
function placeNumbers(view: View, labels: Labels): Numbered[] {
  const { app, camera } = view;
  const numbers: Numbers[] = [];
  const m = camera.matrix();
  for (const { index, point } of view.redDots()) {
    const x = m[0]! * point[0] + m[1]! * point[1] + m[2]! * point[2] + m[3]!;
    const y = m[4]! * point[0] + m[5]! * point[1] + m[6]! * point[2] + m[7]!;
    if (x >= 0 && y >= 0 && x <= camera.width && y <= camera.height) {
      const n = app.program.n[app.place(index).block]!;
      numbers.push({ x: x + 8, y: y - 6, first: n, last: n, count: 1 });
    }
  }
  if (view.isMoving && numbers.length > MANY) {
    return [];
  }
  const box = (number: Numbers): Box => {
    const found = labels.box(said(number), number.x, number.y);
    const over = Math.max(found[2] - camera.width, 0);
    return [found[0] - over, found[1], found[2] - over, found[3]];
  };
  return joined(numbers, box).map((number) => {
    const found = box(number);
    labels.block(found);
    return { text: said(number), x: found[0] + 2, y: number.y, box: found };
  });
}

function drawEnds(view: View, context: CanvasRenderingContext2D, labels: Labels, background: string): void {
  const { path } = view.app;
  const first = path.rows[0];
  const last = path.rows[path.rows.length - 1];
  if (first === undefined || last === undefined) {
    return;
  }
  const { theme, camera } = view;
  const start = camera.project(path.start(first));
  const end = camera.project(path.point(last));
  context.lineWidth = 1.6;
  context.strokeStyle = theme.ink;
  context.fillStyle = background;
  context.beginPath();
  context.moveTo(start.x - 4, start.y - 5);
  context.lineTo(start.x + 6, start.y);
  context.lineTo(start.x - 4, start.y + 5);
  context.closePath();
  context.fill();
  context.stroke();
  context.beginPath();
  context.rect(end.x - 4, end.y - 4, 8, 8);
  context.fill();
  context.stroke();
  for (const [{ x, y }, text] of [
    [start, t('startMark')],
    [end, t('endMark')],
  ] as const) {
    for (const dy of [16, -10]) {
      if (labels.take(labels.box(text, x + 7, y + dy))) {
        labels.draw(text, x + 7, y + dy, theme.faint, background);
        break;
      }
    }
  }
}

function drawMeasured(view: View, context: CanvasRenderingContext2D, labels: Labels, background: string): void {
  const { camera, measured, theme } = view;
  const places = measured.map(({ point }) => camera.project(point));
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.5;
  if (places.length === 2) {
    context.setLineDash([5, 4]);
    context.beginPath();
    context.moveTo(places[0]!.x, places[0]!.y);
    context.lineTo(places[1]!.x, places[1]!.y);
    context.stroke();
    context.setLineDash([]);
    const [a, b] = [measured[0]!.point, measured[1]!.point];
    const text = `${Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]).toFixed(3)} mm`;
    const [x, y] = [(places[0]!.x + places[1]!.x) / 2 + 8, (places[0]!.y + places[1]!.y) / 2 - 6];
    labels.draw(text, x, y, theme.ink, background);
  }
  for (const { x, y } of places) {
    context.beginPath();
    context.moveTo(x - 7, y);
    context.lineTo(x + 7, y);
    context.moveTo(x, y - 7);
    context.lineTo(x, y + 7);
    context.stroke();
  }
}

function drawAxes(view: View, context: CanvasRenderingContext2D): void {
  const { camera, theme } = view;
  const [cx, cy] = [38, camera.height - 34];
  const axes = ['X', 'Y', 'Z'].map((letter, i) => ({
    letter: i === 0 && view.app.header.diameter ? 'ØX' : letter,
    colour: theme.axes[i]!,
    x: camera.right[i]! * 26,
    y: -camera.up[i]! * 26,
    depth: camera.towards[i]!,
  }));
  axes.sort((a, b) => a.depth - b.depth);
  context.font = 'bold 11px system-ui, sans-serif';
  for (const { letter, colour, x, y } of axes) {
    context.strokeStyle = colour;
    context.fillStyle = colour;
    context.lineWidth = 2;
    context.beginPath();
    context.moveTo(cx, cy);
    context.lineTo(cx + x, cy + y);
    context.stroke();
    const length = Math.hypot(x, y);
    if (length > 6) {
      context.fillText(letter, cx + (x / length) * (length + 8) - 4, cy + (y / length) * (length + 8) + 4);
    }
  }
  context.font = '11px system-ui, sans-serif';
}

function drawScale(view: View, context: CanvasRenderingContext2D): void {
  const { camera, theme } = view;
  const step = roundStep(50 / camera.scale);
  const width = step * camera.scale;
  const [right, y] = [camera.width - 16, camera.height - 14];
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.5;
  context.lineCap = 'butt';
  context.beginPath();
  context.moveTo(right - width, y - 4);
  context.lineTo(right - width, y);
  context.lineTo(right, y);
  context.lineTo(right, y - 4);
  context.stroke();
  const text = `${Number(step.toPrecision(12))} mm`;
  context.fillStyle = theme.ink;
  context.fillText(text, right - width / 2 - context.measureText(text).width / 2, y - 6);
}

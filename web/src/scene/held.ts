// The block in hand, over the path: on a canvas no larger than its line. A browser composes all of a canvas anew when some
// of it changed, and every step takes another block in hand.

import type { View } from './view.ts';

/** Room around the line for its edge, its arrow and the tool, in CSS pixels. */
const ROOM = 10;
/** A shorter line has no arrow, in CSS pixels. */
const ARROW = 24;
/** Radius of the tool, in CSS pixels. */
const TOOL = 5;

interface Point {
  x: number;
  y: number;
}

export class Held {
  readonly canvas: HTMLCanvasElement;

  constructor() {
    this.canvas = document.createElement('canvas');
    this.canvas.className = 'held';
    this.canvas.setAttribute('aria-hidden', 'true');
    this.canvas.hidden = true;
  }

  /** Shows the block in hand as the camera sees it now. */
  draw(view: View): void {
    const { app, camera } = view;
    const { path } = app;
    const row = app.current === null ? null : app.program.rowOf(app.current);
    this.canvas.hidden = true;
    if (row === null) {
      return;
    }
    if (!path.hasLine(row)) {
      const place = camera.project(path.point(row));
      this.#over(view, [place], (context) => stand(view, context, place, TOOL + 1));
      return;
    }
    const parts = path.isArc(row) ? Math.min(path.chords(row, 0.2 / camera.scale), 360) : 1;
    const places = Array.from({ length: parts + 1 }, (_, part) => camera.project(path.at(row, part / parts)));
    const tool = camera.project(path.at(row, view.share ?? 1));
    this.#over(view, places, (context) => {
      drawLine(view, context, places);
      const length = places
        .slice(1)
        .reduce((sum, at, i) => sum + Math.hypot(at.x - places[i]!.x, at.y - places[i]!.y), 0);
      if (length > ARROW) {
        drawArrow(view, context, camera.project(path.at(row, 0.49)), camera.project(path.at(row, 0.5)));
      }
      stand(view, context, tool, TOOL);
    });
  }

  /** Lays the canvas over points, as far as they are in sight, and draws on it in pixels of the view. */
  #over(view: View, points: Point[], draw: (context: CanvasRenderingContext2D) => void): void {
    const { camera } = view;
    const within = (value: number, most: number): number => Math.min(Math.max(Math.round(value), 0), most);
    const xs = points.map(({ x }) => x);
    const ys = points.map(({ y }) => y);
    const left = within(Math.min(...xs) - ROOM, camera.width);
    const top = within(Math.min(...ys) - ROOM, camera.height);
    const width = within(Math.max(...xs) + ROOM, camera.width) - left;
    const height = within(Math.max(...ys) + ROOM, camera.height) - top;
    if (width <= 0 || height <= 0) {
      return;
    }
    const { canvas } = this;
    const ratio = window.devicePixelRatio || 1;
    canvas.width = Math.ceil(width * ratio);
    canvas.height = Math.ceil(height * ratio);
    canvas.style.cssText = `left: ${left}px; top: ${top}px; width: ${width}px; height: ${height}px`;
    canvas.hidden = false;
    const context = canvas.getContext('2d')!;
    context.setTransform(ratio, 0, 0, ratio, -left * ratio, -top * ratio);
    context.lineJoin = 'round';
    context.lineCap = 'round';
    draw(context);
  }
}

function drawLine({ theme }: View, context: CanvasRenderingContext2D, places: Point[]): void {
  for (const [width, colour] of [
    [6, theme.selectionEdge],
    [3.2, theme.selection],
  ] as const) {
    context.beginPath();
    for (const [i, { x, y }] of places.entries()) {
      if (i === 0) context.moveTo(x, y);
      else context.lineTo(x, y);
    }
    context.lineWidth = width;
    context.strokeStyle = colour;
    context.stroke();
  }
}

/** Shows the way, in the middle of the line. */
function drawArrow({ theme }: View, context: CanvasRenderingContext2D, before: Point, middle: Point): void {
  context.save();
  context.translate(middle.x, middle.y);
  context.rotate(Math.atan2(middle.y - before.y, middle.x - before.x));
  context.beginPath();
  context.moveTo(8, 0);
  context.lineTo(-5, -6);
  context.lineTo(-5, 6);
  context.closePath();
  context.fillStyle = theme.selection;
  context.fill();
  context.lineWidth = 1.2;
  context.strokeStyle = theme.selectionEdge;
  context.stroke();
  context.restore();
}

/** Where the tool stands. */
function stand({ theme }: View, context: CanvasRenderingContext2D, { x, y }: Point, size: number): void {
  context.beginPath();
  context.arc(x, y, size, 0, 2 * Math.PI);
  context.fillStyle = theme.selection;
  context.fill();
  context.lineWidth = 2;
  context.strokeStyle = theme.selectionEdge;
  context.stroke();
}

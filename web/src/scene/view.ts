// The picture: canvases, camera, hands and keys.

import type { App } from '../app.ts';
import { t } from '../i18n.ts';
import { isDark } from '../theme.ts';
import { type Box, Camera, type Plane, type Vector } from './camera.ts';
import { DARK, LIGHT, type Legend, type Theme, colour, paint, paintHalf, rampCuts } from './colours.ts';
import { Gl, hardwareContext } from './gl.ts';
import { grid, type GridLabel } from './grid.ts';
import { Held } from './held.ts';
import { Lines } from './lines.ts';
import { drawMarks, type MeasurePoint, type Numbered } from './marks.ts';
import { pick } from './pick.ts';
import { Raster } from './raster.ts';
import type { Dots, Renderer } from './renderer.ts';

/** So many chords are drawn in every frame while the picture moves; of more, every so-many-th. */
const FLUENT = 200_000;
/** With more yellow dots than these in sight, they wait until there are fewer. */
const MOST_YELLOW = 4000;
/** The picture rests after so many milliseconds without a move. */
const REST = 120;

export type Standard = Plane | 'fit';
/** What is to be in sight: the working motions, or all. */
export type Extent = 'work' | 'all';

/** What a frame draws anew: each includes those before it. */
const AMOUNTS = ['nothing', 'held', 'marks', 'all'] as const;
type Amount = (typeof AMOUNTS)[number];

export class View {
  readonly app: App;
  readonly element: HTMLElement;
  readonly canvas: HTMLCanvasElement;
  readonly camera = new Camera();
  theme: Theme = LIGHT;
  legend: Legend = { kind: 'names', items: [] };
  lines!: Lines;
  /** Those of the old program, on a page of `compare`. */
  under: Lines | undefined;
  /** Those of the change that is shown. */
  over: Lines[] = [];
  /** Asked for points of the path by a click, instead of a block. */
  onPoint: ((point: MeasurePoint) => void) | undefined;
  measured: MeasurePoint[] = [];
  /** The numbers at red dots, until the picture is drawn anew. */
  numbered: Numbered[] | undefined;
  /** Where the tool stands within the block in hand while it plays, 0 to 1. */
  share: number | undefined;
  /** Called after each picture. */
  onDrawn: ((facts: { thinned: boolean; yellowHidden: boolean }) => void) | undefined;
  onLegend: (() => void) | undefined;
  readonly #held = new Held();
  readonly #marks: HTMLCanvasElement;
  readonly #renderer: Renderer;
  /** What the next frame draws. */
  #wanted: Amount = 'nothing';
  #gridLabels: GridLabel[] = [];
  #ratio = 0;
  #moving = false;
  #restTimer = 0;
  #dots: Dots = { points: new Float32Array(0), red: new Uint8Array(0) };
  #redDots: Int32Array | undefined;
  #dotsFor = '';
  #yellowHidden = false;
  #standard: Standard = 'iso';
  #untouched = true;
  #slow = 1;

  constructor(app: App, element: HTMLElement) {
    this.app = app;
    this.element = element;
    this.canvas = document.createElement('canvas');
    this.canvas.id = 'path';
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('role', 'application');
    this.#marks = document.createElement('canvas');
    this.#marks.className = 'marks';
    this.#marks.setAttribute('aria-hidden', 'true');
    element.append(this.canvas, this.#held.canvas, this.#marks);
    this.#renderer = makeRenderer(this.canvas);
    element.dataset['renderer'] = this.#renderer.name;
    this.theme = isDark() ? DARK : LIGHT;
    this.#load();
    // Before others, who take colours from here.
    app.on('theme', () => {
      this.theme = isDark() ? DARK : LIGHT;
      this.#choose();
      this.repaint();
    });
    app.on('data', () => this.#load());
    app.on('colour', () => this.#recolour());
    app.on('change', () => this.#choose());
    app.on('together', () => this.request('marks'));
    app.on('filter', () => this.#rebuild());
    app.on('shown', () => this.#rebuild());
    app.on('select', () => this.request('held'));
    app.on('language', () => this.request());
    new ResizeObserver(() => {
      if (this.#resize()) {
        this.#draw();
      }
    }).observe(element);
    this.#hands();
    this.#keys();
    this.#resize();
  }

  get rendererName(): string {
    return this.#renderer.name;
  }

  #load(): void {
    this.measured = [];
    this.#redDots = undefined;
    this.#dotsFor = '';
    this.#rebuild();
    if (this.#untouched) {
      this.look(this.#startPlane(), 'work');
      this.#untouched = true;
    }
  }

  /** A lathe is seen in ZX, a flat program from above, or from where its plane is. */
  #startPlane(): Plane {
    if (this.app.header.turning) {
      return 'ZX';
    }
    const { min, max } = this.app.path.box;
    const size = min.map((low, i) => max[i]! - low);
    const missing = [0, 1, 2].filter((i) => size[i]! < 1e-9);
    return missing.length === 1 ? (['YZ', 'XZ', 'XY'] as const)[missing[0]!]! : 'iso';
  }

  #rebuild(): void {
    const { app } = this;
    const deviation = Math.max(0.4 / this.camera.scale, 1e-5);
    const seen = app.isFiltered ? app.shownRows() : undefined;
    const hidden =
      seen === undefined
        ? undefined
        : (row: number): boolean => (!app.shown.rapids && app.path.kind(row) === 0) || seen[row] === 0;
    this.lines = new Lines(app.path, deviation, hidden, app.colourBy === 'velocity' ? rampCuts(app) : undefined);
    const old = app.shown.old ? app.comparison?.old.path : undefined;
    const still = (row: number): boolean => !app.shown.rapids && old?.kind(row) === 0;
    this.under = old && new Lines(old, deviation, still);
    this.#choose();
    this.#renderer.changed('points');
    this.#dotsFor = '';
    this.repaint();
  }

  /** Colours by velocity need lines that are cut where it changes. */
  #recolour(): void {
    const cut = this.app.colourBy === 'velocity' && this.app.times !== undefined;
    if (cut === (this.lines.cuts !== undefined)) {
      this.repaint();
    } else {
      this.#rebuild();
    }
  }

  /** Whether the hand moves the picture. */
  get isMoving(): boolean {
    return this.#moving;
  }

  /** Gives the lines their colours again. */
  repaint(): void {
    const { dashes } = this.lines;
    this.#paint();
    this.#renderer.changed(dashes === this.lines.dashes ? 'colours' : 'points');
    this.onLegend?.();
    this.request();
  }

  /** The lines of the change that is shown, of both programs. */
  #choose(): void {
    const { comparison } = this.app;
    this.over = comparison?.chosenLines(this.lines.deviation, colour(this.theme.selection)) ?? [];
    this.request();
  }

  #paint(): void {
    const { app, lines, under, theme } = this;
    this.legend = paint(app, lines, theme, app.colourBy);
    if (under !== undefined && app.comparison !== undefined) {
      paintHalf(app.comparison, 'old', under, theme);
    }
  }

  /** Takes the size of the page; whether it has changed. */
  #resize(): boolean {
    const { clientWidth, clientHeight } = this.element;
    const known = this.camera.width === clientWidth && this.camera.height === clientHeight;
    if (clientWidth === 0 || clientHeight === 0 || (known && this.#ratio === window.devicePixelRatio)) {
      return false;
    }
    this.#ratio = window.devicePixelRatio;
    const refit = this.#untouched;
    this.camera.width = clientWidth;
    this.camera.height = clientHeight;
    const ratio = window.devicePixelRatio || 1;
    this.#renderer.resize(clientWidth, clientHeight, ratio);
    this.#marks.width = Math.round(clientWidth * ratio);
    this.#marks.height = Math.round(clientHeight * ratio);
    if (refit) {
      this.#fit(this.app.path.workingBox ?? this.app.path.box);
    }
    return true;
  }

  /** Shows a plane, or the path from where it is seen: the working motions first, all when asked again. */
  look(standard: Standard, extent: Extent = 'all'): void {
    const { app, camera } = this;
    const shown = camera.matrix().join(' ');
    if (standard !== 'fit') {
      camera.look(standard);
      this.#standard = standard;
    }
    const work = standard === 'fit' || extent === 'work' ? app.path.workingBox : undefined;
    this.#fit(work ?? app.path.box);
    // Who asks again for what is shown wants the rest.
    if (work !== undefined && camera.matrix().join(' ') === shown) {
      this.#fit(app.path.box);
    }
    this.#untouched = false;
    this.request();
  }

  /** Moves the picture when a place is not in sight, so that it is in the middle. */
  reveal(point: Vector): void {
    const { camera } = this;
    const { x, y } = camera.project(point);
    if (x < 0 || y < 0 || x > camera.width || y > camera.height) {
      camera.pan(camera.width / 2 - x, camera.height / 2 - y);
      this.#untouched = false;
      this.request();
    }
  }

  get standard(): Standard {
    return this.#standard;
  }

  #fit(box: Box): void {
    const { camera } = this;
    const [wide, high] = [Math.min(52, camera.width * 0.12), Math.min(48, camera.height * 0.12)];
    camera.fit(box, [wide, high, wide, high]);
  }

  /** The picture, or only what stands over the path, or only the block in hand, is drawn anew before the next frame. */
  request(what: Amount = 'all'): void {
    if (this.#wanted === 'nothing') {
      requestAnimationFrame(() => {
        const wanted = this.#wanted;
        this.#wanted = 'nothing';
        if (wanted === 'all') {
          this.#draw();
        } else if (wanted !== 'nothing') {
          this.#held.draw(this);
          if (wanted === 'marks') {
            drawMarks(this, this.#marks, this.#gridLabels);
          }
        }
      });
    }
    if (AMOUNTS.indexOf(what) > AMOUNTS.indexOf(this.#wanted)) {
      this.#wanted = what;
    }
  }

  /** The hand moves the picture: it need not be complete until it rests. */
  #moved(): void {
    this.#untouched = false;
    this.#moving = true;
    window.clearTimeout(this.#restTimer);
    this.#restTimer = window.setTimeout(() => {
      this.#moving = false;
      this.request();
    }, REST);
    this.request();
  }

  drawNow(): void {
    this.#resize();
    this.#wanted = 'nothing';
    this.#draw();
  }

  #draw(): void {
    const { app, camera, theme } = this;
    this.numbered = undefined;
    if (!this.#moving) {
      this.refine();
    }
    const { lines, under } = this;
    const count = lines.count + (under?.count ?? 0);
    const step = this.#moving ? Math.max(Math.ceil((count / FLUENT) * this.#slow), 1) : 1;
    const begun = performance.now();
    const empty = { underlay: { points: [], colours: [] }, labels: [] as GridLabel[] };
    const drawn = app.shown.grid && app.path.rows.length > 0;
    const { underlay, labels } = drawn ? grid(app.path.box, camera, theme, app.header.diameter) : empty;
    this.#chooseDots();
    this.#withEquidistant(underlay);
    const matrix = camera.matrix();
    this.#renderer.draw({
      background: theme.background,
      matrix,
      underlay,
      lines,
      under: under === undefined ? [] : [under],
      over: this.over,
      until: lines.count,
      step,
      width: lines.count > 60_000 ? 1 : 1.5,
      dots: this.#dots,
      dotColours: { red: theme.red, yellow: theme.yellow, edge: theme.dotEdge },
    });
    this.#gridLabels = labels;
    this.#held.draw(this);
    drawMarks(this, this.#marks, labels);
    const took = performance.now() - begun;
    if (this.#moving && count > FLUENT) {
      this.#slow = Math.min(Math.max(this.#slow * (took > 45 ? 1.5 : took < 20 ? 0.8 : 1), 1), 16);
    }
    const waits = this.#moving && app.shown.numbers && app.shown.red && (this.#redDots?.length ?? 0) > 3000;
    this.onDrawn?.({ thinned: step > 1 || waits, yellowHidden: this.#yellowHidden });
  }

  /** Cuts arcs into as many chords as they need at this scale. */
  refine(): void {
    if (this.lines.isCoarse(this.camera.scale)) {
      this.lines = new Lines(this.app.path, 0.25 / this.camera.scale, this.lines.filter, this.lines.cuts);
      this.under &&= new Lines(this.under.path, 0.25 / this.camera.scale, this.under.filter);
      this.#choose();
      this.#paint();
      this.#renderer.changed('points');
    }
  }

  #withEquidistant(underlay: { points: Vector[]; colours: number[] }): void {
    const { header, shown } = this.app;
    if (header.equidistant === undefined || !shown.equidistant) {
      return;
    }
    for (const piece of header.equidistant.pieces) {
      const { points } = piece;
      for (let at = 0; at + 5 < points.length; at += 3) {
        underlay.points.push(
          [points[at]!, points[at + 1]!, points[at + 2]!],
          [points[at + 3]!, points[at + 4]!, points[at + 5]!],
        );
        underlay.colours.push(piece.bad ? this.theme.collision : this.theme.equidistant);
      }
    }
  }

  /** Places of the red dots that may be numbered, with their blocks. */
  redDots(): { index: number; point: Vector }[] {
    const { app } = this;
    const { path, program } = app;
    this.#redDots ??= app.times?.redDots() ?? new Int32Array(0);
    const seen = app.isFiltered ? this.#redDots.filter((index) => !app.isHidden(index)) : this.#redDots;
    return Array.from(seen, (index) => ({ index, point: path.start(program.rowOf(index)) }));
  }

  /** The dots that are drawn: those in sight, and yellow ones only while they are not too many. */
  #chooseDots(): void {
    const { app, camera } = this;
    const { path, program, times, shown } = app;
    const all = times?.dots() ?? new Int32Array(0);
    const many = all.length > MOST_YELLOW;
    // Few dots are the same whatever is in sight.
    const key = `${shown.red} ${shown.yellow} ${many ? `${camera.matrix().join(' ')} ${camera.width} ${camera.height}` : ''}`;
    if (key === this.#dotsFor) {
      return;
    }
    this.#dotsFor = key;
    const m = camera.matrix();
    const inSight = path.within(m, camera.width, camera.height);
    const kept: number[] = [];
    let yellow = 0;
    for (const index of all) {
      const isRed = times!.dotOf(index) === 'red';
      if (
        (isRed ? !shown.red : !shown.yellow || yellow > MOST_YELLOW) ||
        (app.isFiltered && app.isHidden(index)) ||
        (many && !inSight(program.before[program.rowOf(index)]!))
      ) {
        continue;
      }
      yellow += isRed ? 0 : 1;
      kept.push(index);
    }
    this.#yellowHidden = yellow > MOST_YELLOW;
    const drawn = this.#yellowHidden ? kept.filter((index) => times!.dotOf(index) === 'red') : kept;
    const points = new Float32Array(3 * drawn.length);
    const red = new Uint8Array(drawn.length);
    drawn.forEach((index, i) => {
      points.set(path.start(program.rowOf(index)), 3 * i);
      red[i] = times!.dotOf(index) === 'red' ? 1 : 0;
    });
    this.#dots = { points, red };
  }

  /** The executed block whose line runs by a place of the canvas, as an index. */
  pick(x: number, y: number): number | null {
    this.refine();
    return pick(this, x, y)?.index ?? null;
  }

  #hands(): void {
    const { canvas, camera } = this;
    const pointers = new Map<number, { x: number; y: number }>();
    let travelled = 0;
    let pressed = 0;
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, { x: event.offsetX, y: event.offsetY });
      travelled = 0;
      pressed = event.button;
      canvas.focus({ preventScroll: true });
      event.preventDefault();
    });
    canvas.addEventListener('pointermove', (event) => {
      const before = pointers.get(event.pointerId);
      if (before === undefined) {
        return;
      }
      const now = { x: event.offsetX, y: event.offsetY };
      const [dx, dy] = [now.x - before.x, now.y - before.y];
      travelled += Math.abs(dx) + Math.abs(dy);
      if (travelled < 3 && pointers.size === 1) {
        return;
      }
      if (pointers.size === 2) {
        const other = [...pointers].find(([id]) => id !== event.pointerId)![1];
        const far = (a: { x: number; y: number }): number => Math.hypot(a.x - other.x, a.y - other.y) || 1;
        camera.pan(dx / 2, dy / 2);
        camera.zoom(far(now) / far(before), (now.x + other.x) / 2, (now.y + other.y) / 2);
      } else if (event.shiftKey || pressed === 2 || pressed === 1) {
        camera.pan(dx, dy);
      } else {
        camera.turn(-dx * 0.008, -dy * 0.008);
      }
      pointers.set(event.pointerId, now);
      this.#moved();
    });
    const released = (event: PointerEvent): void => {
      const known = pointers.delete(event.pointerId);
      if (known && travelled < 3 && event.type === 'pointerup' && event.button === 0) {
        this.#clicked(event.offsetX, event.offsetY);
      }
    };
    canvas.addEventListener('pointerup', released);
    canvas.addEventListener('pointercancel', released);
    canvas.addEventListener(
      'wheel',
      (event) => {
        event.preventDefault();
        const lines = event.deltaMode === 1 ? 24 : 1;
        camera.zoom(Math.exp(-event.deltaY * lines * 0.0015), event.offsetX, event.offsetY);
        this.#moved();
      },
      { passive: false },
    );
  }

  #clicked(x: number, y: number): void {
    const found = pick(this, x, y);
    if (this.onPoint !== undefined) {
      if (found !== null) {
        this.onPoint({ index: found.index, point: found.point });
      }
      return;
    }
    if (found !== null) {
      this.app.select(found.index);
    }
  }

  /** What keys do in the path; those that are not for the camera are left to others. */
  #keys(): void {
    const { camera } = this;
    this.canvas.addEventListener('keydown', (event) => {
      if (event.ctrlKey || event.altKey || event.metaKey) {
        return;
      }
      const turn = Math.PI / 24;
      const far = 40;
      const arrows: { [key: string]: [number, number] } = {
        ArrowLeft: [-1, 0],
        ArrowRight: [1, 0],
        ArrowUp: [0, -1],
        ArrowDown: [0, 1],
      };
      const arrow = arrows[event.key];
      if (arrow !== undefined) {
        const [x, y] = arrow;
        if (event.shiftKey) {
          camera.pan(x * far, y * far);
        } else {
          camera.turn(-x * turn, -y * turn);
        }
      } else if (event.key === '+' || event.key === '=') {
        camera.zoom(1.25);
      } else if (event.key === '-' || event.key === '_') {
        camera.zoom(0.8);
      } else if (event.key === 'Enter' && this.onPoint !== undefined) {
        const { current, program, path } = this.app;
        if (current !== null) {
          this.onPoint({ index: current, point: path.point(program.rowOf(current)) });
        }
      } else if (event.key === 'Home') {
        this.look('fit');
      } else {
        return;
      }
      event.preventDefault();
      this.#moved();
    });
  }

  /** What the canvas says to those who do not see it. */
  describe(): void {
    this.canvas.setAttribute('aria-label', t('canvas'));
  }
}

function makeRenderer(canvas: HTMLCanvasElement): Renderer {
  const forced = window.location.hash === '#draw=gl';
  const gl = window.location.hash === '#draw=software' ? null : hardwareContext(canvas, forced);
  if (gl !== null) {
    return new Gl(gl);
  }
  const context = canvas.getContext('2d', { alpha: false });
  if (context === null) {
    throw new Error('canvas');
  }
  return new Raster(canvas, context);
}

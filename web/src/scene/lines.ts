// The lines of the path as chords for drawing: flat arrays, whatever the number.

import type { Path } from './path.ts';
import type { Vector } from './camera.ts';

/** How a chord is dashed. */
export const enum Dash {
  Solid = 0,
  Rapid = 1,
  Long = 2,
  Short = 3,
}

/** By dash: how long it is, and how long with the gap behind it, in CSS pixels. */
export const DASHES: readonly [number, number][] = [
  [1, 1],
  [6, 12],
  [15, 21],
  [3, 7],
];

/** Shares of the way of straight lines at which they are cut, ascending; none for those that stay whole. */
export type Cuts = (row: number) => readonly number[];

/** Chords of the path. Points are single precision about `origin`, for drawing only. */
export class Lines {
  readonly path: Path;
  readonly origin: Vector;
  /** Six numbers a chord: from, to. */
  points: Float32Array = new Float32Array(0);
  /** By chord: its row. */
  rows: Int32Array = new Int32Array(0);
  /** By chord: its kind. */
  kinds: Uint8Array = new Uint8Array(0);
  /** Two a chord, at its ends: 0xAABBGGRR. */
  colours: Uint32Array = new Uint32Array(0);
  /** By chord: at which share of its row's way it ends. Only when straight lines are cut. */
  ends: Float32Array | undefined;
  /** By chord, when lines that are no rapid motion are dashed too. */
  dashes: Uint8Array | undefined;
  /** By chord: which unbroken run it belongs to. Made when first asked for. */
  #runs: Int32Array | undefined;
  /** How far chords of arcs may be from them, in mm. */
  deviation: number;
  /** Whether a row is left out by a filter. */
  readonly #isHidden: ((row: number) => boolean) | undefined;
  /** Which rows are left out. */
  get filter(): ((row: number) => boolean) | undefined {
    return this.#isHidden;
  }

  /** Where straight lines are cut. */
  readonly cuts: Cuts | undefined;

  /** How many rows are drawn. */
  drawn = 0;

  constructor(path: Path, deviation: number, isHidden?: (row: number) => boolean, cuts?: Cuts) {
    this.path = path;
    this.deviation = deviation;
    this.#isHidden = isHidden;
    this.cuts = cuts;
    this.origin = path.box.min.map((low, i) => (low + path.box.max[i]!) / 2) as Vector;
    this.#build();
  }

  get count(): number {
    return this.rows.length;
  }

  /** Whether arcs look like chords at this scale, in CSS pixels a millimetre. */
  isCoarse(scale: number): boolean {
    return this.path.program.centerAt !== undefined && this.deviation * scale > 0.5;
  }

  #build(): void {
    const { path } = this;
    const hidden = this.#isHidden;
    const rows = hidden === undefined ? path.rows : path.rows.filter((row) => !hidden(row));
    this.drawn = rows.length;
    const { cuts } = this;
    const arcs = path.program.centerAt !== undefined;
    const chords = (row: number, deviation: number): number =>
      cuts === undefined || path.isArc(row) ? path.chords(row, deviation) : cuts(row).length + 1;
    let count = rows.length;
    let parts: Uint16Array | undefined;
    if (arcs || cuts !== undefined) {
      parts = new Uint16Array(rows.length);
      count = 0;
      // The more arcs there are, the fewer chords each.
      const deviation = Math.max(this.deviation, 0);
      for (let i = 0; i < rows.length; i += 1) {
        parts[i] = chords(rows[i]!, deviation);
        count += parts[i]!;
      }
      while (arcs && count > 1.5e6 && count > 3 * rows.length) {
        this.deviation *= 4;
        count = 0;
        for (let i = 0; i < rows.length; i += 1) {
          parts[i] = chords(rows[i]!, this.deviation);
          count += parts[i]!;
        }
      }
    }
    this.points = new Float32Array(6 * count);
    this.kinds = new Uint8Array(count);
    this.rows = count === rows.length ? rows : new Int32Array(count);
    this.colours = new Uint32Array(2 * count);
    this.ends = cuts === undefined ? undefined : new Float32Array(count).fill(1);
    this.dashes = undefined;
    this.#runs = undefined;
    this.#fill(rows, parts);
  }

  #fill(rows: Int32Array, parts: Uint16Array | undefined): void {
    const { path, points } = this;
    const { program } = path;
    const axes = ['X', 'Y', 'Z'].map((letter) => program.letters.indexOf(letter));
    const [ox, oy, oz] = this.origin;
    const none = new Int32Array(0);
    const [px, py, pz] = axes.map((axis) => program.position[axis] ?? none) as [Int32Array, Int32Array, Int32Array];
    const [sx, sy, sz] = axes.map((axis) => program.per[axis] ?? 1) as Vector;
    const [hasX, hasY, hasZ] = axes.map((axis) => axis >= 0) as [boolean, boolean, boolean];
    let chord = 0;
    let at = 0;
    for (let i = 0; i < rows.length; i += 1) {
      const row = rows[i]!;
      const kind = path.kind(row);
      const pieces = parts === undefined ? 1 : parts[i]!;
      if (pieces === 1) {
        const before = program.before[row]!;
        points[at] = (hasX ? px[before]! / sx : 0) - ox;
        points[at + 1] = (hasY ? py[before]! / sy : 0) - oy;
        points[at + 2] = (hasZ ? pz[before]! / sz : 0) - oz;
        points[at + 3] = (hasX ? px[row]! / sx : 0) - ox;
        points[at + 4] = (hasY ? py[row]! / sy : 0) - oy;
        points[at + 5] = (hasZ ? pz[row]! / sz : 0) - oz;
        this.rows[chord] = row;
        this.kinds[chord] = kind;
        chord += 1;
        at += 6;
        continue;
      }
      let from = path.start(row);
      const cuts = this.cuts === undefined || path.isArc(row) ? undefined : this.cuts(row);
      for (let piece = 1; piece <= pieces; piece += 1) {
        const share = cuts === undefined ? piece / pieces : (cuts[piece - 1] ?? 1);
        const to = path.at(row, share);
        for (let j = 0; j < 3; j += 1) {
          points[at + j] = from[j]! - this.origin[j]!;
          points[at + 3 + j] = to[j]! - this.origin[j]!;
        }
        from = to;
        if (this.ends !== undefined) {
          this.ends[chord] = share;
        }
        this.rows[chord] = row;
        this.kinds[chord] = kind;
        chord += 1;
        at += 6;
      }
    }
  }

  /** How a chord is dashed. */
  dash(chord: number): Dash {
    return this.kinds[chord] === 0 ? Dash.Rapid : (this.dashes?.[chord] ?? Dash.Solid);
  }

  /** By chord: which unbroken run of one kind it belongs to. */
  get runs(): Int32Array {
    if (this.#runs === undefined) {
      const { points, kinds, count } = this;
      const runs = new Int32Array(count);
      let run = 0;
      for (let chord = 1, at = 6; chord < count; chord += 1, at += 6) {
        const joined =
          points[at] === points[at - 3] &&
          points[at + 1] === points[at - 2] &&
          points[at + 2] === points[at - 1] &&
          (kinds[chord] === 0) === (kinds[chord - 1] === 0);
        run += joined ? 0 : 1;
        runs[chord] = run;
      }
      this.#runs = runs;
    }
    return this.#runs;
  }

  /** The chords of a row: the first, and how many. */
  chordsOf(row: number): [number, number] {
    let low = 0;
    let high = this.count;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.rows[middle]! < row) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    let end = low;
    while (end < this.count && this.rows[end] === row) {
      end += 1;
    }
    return [low, end - low];
  }

  /** A projection for these points: that of the camera, about the origin. */
  about(matrix: Float64Array): Float64Array {
    const m = matrix.slice();
    for (const at of [0, 4, 8]) {
      m[at + 3]! += m[at]! * this.origin[0] + m[at + 1]! * this.origin[1] + m[at + 2]! * this.origin[2];
    }
    return m;
  }
}

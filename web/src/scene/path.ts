// The lines of the path: which rows have one, and their shape in space.

import type { Numbers } from '../data/columns.ts';
import type { Shape } from '../data/header.ts';
import type { Program } from '../data/program.ts';
import type { Box, Vector } from './camera.ts';

/** What is done along a line. */
export const enum Kind {
  Rapid = 0,
  Linear = 1,
  Arc = 2,
  Thread = 3,
}

interface LineShape {
  kind: Kind;
  arc: boolean;
  /** Start or end of one of X, Y, Z is not known. */
  unknown: boolean;
}

/** Where the three axes of space are among those of the machine, -1 where it has none. */
function spaceAxes(program: Program): Vector {
  return ['X', 'Y', 'Z'].map((letter) => program.letters.indexOf(letter)) as Vector;
}

/** What a shape draws; nothing when it moves none of X, Y, Z. */
function lineOf(shape: Shape): LineShape | undefined {
  if (shape.u === true && shape.m === undefined) {
    return { kind: Kind.Linear, arc: false, unknown: true };
  }
  const type = shape.m?.['type'];
  const moved = ((shape.m?.['axes'] ?? []) as string[]).filter((letter) => 'XYZ'.includes(letter));
  if (typeof type !== 'string' || moved.length === 0) {
    return undefined;
  }
  const arc = type.startsWith('arc');
  const known = moved.every((letter) => shape.s?.includes(letter) && shape.k?.includes(letter));
  const unknown = !known || type === 'reference' || (arc && shape.r === undefined);
  const kind = type === 'rapid' ? Kind.Rapid : arc ? Kind.Arc : type === 'thread' ? Kind.Thread : Kind.Linear;
  return { kind, arc, unknown };
}

/** The lines of a program, by row. */
export class Path {
  readonly program: Program;
  /** Rows with a line, ascending. */
  readonly rows: Int32Array;
  /** Around all lines, and around the working ones, if there are any. */
  readonly box: Box;
  readonly workingBox: Box | undefined;
  /** Executed blocks whose line is not drawn because its start or end is not known. */
  readonly unknown: number;
  /** Executed blocks whose line starts from a position of another origin. */
  readonly stale: number;
  /** Executed blocks with a line. */
  readonly segments: number;
  /** The places of X, Y, Z among the axes of the machine; -1: it has none. */
  readonly axes: Vector;
  readonly #shapes: (LineShape | undefined)[];

  constructor(program: Program) {
    this.program = program;
    this.axes = spaceAxes(program);
    this.#shapes = program.header.shapes.map(lineOf);
    const [X, Y, Z] = this.axes;
    const rows = new Int32Array(program.rows);
    const none = new Uint8Array(program.rows);
    const [px, py, pz] = [X, Y, Z].map((axis) => program.position[axis] ?? none) as [Numbers, Numbers, Numbers];
    const hasLine = new Uint8Array(program.rows);
    let count = 0;
    for (let row = 1; row < program.rows; row += 1) {
      const line = this.#shapes[program.shape[row]!];
      if (line === undefined) {
        continue;
      }
      if (line.unknown) {
        hasLine[row] = 2;
        continue;
      }
      const before = program.before[row]!;
      const moves = px[row] !== px[before] || py[row] !== py[before] || pz[row] !== pz[before];
      if (moves || (line.arc && this.#isArcInSpace(row))) {
        hasLine[row] = 1;
        rows[count] = row;
        count += 1;
      }
    }
    this.rows = rows.slice(0, count);
    const executions = [0, count, 0];
    if (program.count + 1 === program.rows) {
      executions[2] = hasLine.reduce((sum, kind) => sum + (kind === 2 ? 1 : 0), 0);
    } else {
      executions[1] = 0;
      for (let index = 0; index < program.count; index += 1) {
        executions[hasLine[program.rowOf(index)]!]! += 1;
      }
    }
    this.segments = executions[1]!;
    this.unknown = executions[2]!;
    this.stale = this.#stale(hasLine);
    [this.box, this.workingBox] = this.#boxes();
  }

  #stale(hasLine: Uint8Array): number {
    const { program } = this;
    let count = 0;
    if (program.header.shapes.some((shape) => shape.o === true)) {
      for (let index = 0; index < program.count; index += 1) {
        const row = program.rowOf(index);
        count += hasLine[row] === 1 && program.shapeOf(row).o === true ? 1 : 0;
      }
    }
    return count;
  }

  #isArcInSpace(row: number): boolean {
    const shape = this.program.shapeOf(row);
    return [...(shape.r ?? '')].some((letter) => 'XYZ'.includes(letter));
  }

  kind(row: number): Kind {
    return this.#shapes[this.program.shape[row]!]!.kind;
  }

  isArc(row: number): boolean {
    return this.#shapes[this.program.shape[row]!]?.arc === true;
  }

  /** Whether a row has a line. */
  hasLine(row: number): boolean {
    let low = 0;
    let high = this.rows.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.rows[middle]! < row) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low < this.rows.length && this.rows[low] === row;
  }

  /** Whether the position of an axis of the machine is known after some row. */
  isEverKnown(axis: number): boolean {
    const { header, letters } = this.program;
    return axis >= 0 && header.shapes.some((shape) => shape.k?.includes(letters[axis]!));
  }

  /** Whether all of X, Y, Z that are ever known are known before and after a row. */
  isKnown(row: number): boolean {
    const { program } = this;
    const before = program.before[row]!;
    const known = (axis: number): boolean =>
      !this.isEverKnown(axis) || (program.isKnown(row, axis) && program.isKnown(before, axis));
    return this.axes.every(known);
  }

  /** Where the tool stands after a row, in millimetres; 0 along an axis that the machine has not. */
  point(row: number): Vector {
    return this.axes.map((axis) => (axis < 0 ? 0 : this.program.positionOf(row, axis))) as Vector;
  }

  start(row: number): Vector {
    return this.point(this.program.before[row]!);
  }

  /** Tells of rows whether the tool stands within so many pixels after them, by the coefficients of a projection. */
  within(m: Float64Array, width: number, height: number): (row: number) => boolean {
    const none = new Uint8Array(0);
    const [px, py, pz] = this.axes.map((axis) => this.program.position[axis] ?? none) as [Numbers, Numbers, Numbers];
    const [sx, sy, sz] = this.axes.map((axis) => 1 / (this.program.per[axis] ?? 1)) as Vector;
    return (row) => {
      const [x, y, z] = [(px[row] ?? 0) * sx, (py[row] ?? 0) * sy, (pz[row] ?? 0) * sz];
      const px0 = m[0]! * x + m[1]! * y + m[2]! * z + m[3]!;
      const py0 = m[4]! * x + m[5]! * y + m[6]! * z + m[7]!;
      return px0 >= 0 && py0 >= 0 && px0 <= width && py0 <= height;
    };
  }

  /** The point of a line at a share of its way, 0 to 1. */
  at(row: number, share: number): Vector {
    const from = this.start(row);
    const to = this.point(row);
    const point = from.map((value, i) => value + (to[i]! - value) * share) as Vector;
    if (!this.isArc(row)) {
      return point;
    }
    const { program } = this;
    const shape = program.shapeOf(row);
    const [u, v] = [program.letters.indexOf(shape.r![0]!), program.letters.indexOf(shape.r![1]!)];
    const [toU, toV] = program.toCenter(row);
    const before = program.before[row]!;
    const radius = Math.hypot(toU, toV);
    const endU = program.positionOf(row, u) - program.positionOf(before, u) - toU;
    const endV = program.positionOf(row, v) - program.positionOf(before, v) - toV;
    const angle = Math.atan2(-toV, -toU) + program.sweep(row, shape) * share;
    // Start and end may lie a little differently far from the centre.
    const far = radius + (Math.hypot(endU, endV) - radius) * share;
    const [x, y] = [
      program.positionOf(before, u) + toU + far * Math.cos(angle),
      program.positionOf(before, v) + toV + far * Math.sin(angle),
    ];
    for (const [axis, value] of [
      [u, x],
      [v, y],
    ] as const) {
      const place = this.axes.indexOf(axis);
      if (place >= 0) {
        point[place] = value;
      }
    }
    return point;
  }

  /** The direction of a line at its start or end, of length 1 unless it has none. */
  direction(row: number, atEnd: boolean): Vector {
    const [a, b] = this.isArc(row) ? (atEnd ? [1 - 1e-6, 1] : [0, 1e-6]) : [0, 1];
    const [from, to] = [this.at(row, a!), this.at(row, b!)];
    const step = to.map((value, i) => value - from[i]!) as Vector;
    const length = Math.hypot(...step);
    return length > 0 ? (step.map((value) => value / length) as Vector) : step;
  }

  /** Into how many chords an arc is cut so that none is further from it than `deviation` millimetres. */
  chords(row: number, deviation: number): number {
    if (!this.isArc(row)) {
      return 1;
    }
    const { program } = this;
    const radius = Math.hypot(...program.toCenter(row));
    const sweep = Math.abs(program.sweep(row, program.shapeOf(row)));
    const step = radius > deviation ? 2 * Math.acos(1 - deviation / radius) : Math.PI / 2;
    return Math.min(Math.max(Math.ceil(sweep / step), Math.ceil((sweep * 4) / Math.PI), 2), 720);
  }

  /** Makes room for another path. */
  embrace(other: Path): void {
    for (const [own, others] of [
      [this.box, other.box],
      [this.workingBox, other.workingBox],
    ] as const) {
      own?.min.forEach((low, i) => {
        own.min[i] = Math.min(low, others?.min[i] ?? low);
        own.max[i] = Math.max(own.max[i]!, others?.max[i] ?? own.max[i]!);
      });
    }
  }

  #boxes(): [Box, Box | undefined] {
    const empty = (): Box => ({ min: [Infinity, Infinity, Infinity], max: [-Infinity, -Infinity, -Infinity] });
    const all = empty();
    const working = empty();
    const { program } = this;
    const [X, Y, Z] = this.axes;
    const include = (box: Box, i: number, value: number): void => {
      if (value < box.min[i]!) {
        box.min[i] = value;
      }
      if (value > box.max[i]!) {
        box.max[i] = value;
      }
    };
    [X, Y, Z].forEach((axis, i) => {
      const position = program.position[axis];
      const per = program.per[axis] ?? 1;
      const { rows } = this;
      for (let place = 0; place < rows.length; place += 1) {
        const row = rows[place]!;
        const works = this.kind(row) !== Kind.Rapid;
        const from = position === undefined ? 0 : position[program.before[row]!]! / per;
        const to = position === undefined ? 0 : position[row]! / per;
        include(all, i, from);
        include(all, i, to);
        if (works) {
          include(working, i, from);
          include(working, i, to);
        }
      }
    });
    for (const row of this.rows) {
      if (this.isArc(row)) {
        const parts = this.chords(row, 1e-3);
        for (let part = 1; part < parts; part += 1) {
          this.at(row, part / parts).forEach((value, i) => {
            include(all, i, value);
            include(working, i, value);
          });
        }
      }
    }
    const isEmpty = (box: Box): boolean => box.min[0] > box.max[0];
    if (isEmpty(all)) {
      const stand = this.program.rows > 0 ? this.point(this.program.rows - 1) : ([0, 0, 0] as Vector);
      all.min = [...stand];
      all.max = [...stand];
    }
    return [all, isEmpty(working) ? undefined : working];
  }
}

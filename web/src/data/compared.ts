// What two programs do differently: the changes, the path of the old program, and which rows of both are in which change.

import { Dash, Lines } from '../scene/lines.ts';
import { Path } from '../scene/path.ts';
import type { Container } from './columns.ts';
import type { Compared, Fields, Header } from './header.ts';
import { Program } from './program.ts';

/** Which of the two programs. */
export type Side = 'old' | 'new';

/** What became of a row: its line runs as before, the same way under other values, or elsewhere. */
export const enum Fate {
  Same = 0,
  Values = 1,
  Moved = 2,
}

/** A program with what became of its rows. */
export interface Half {
  program: Program;
  path: Path;
  /** By row, a `Fate`. */
  fates: Uint8Array;
  /** By row: one more than the place of its first change, 0 without one. */
  changes: Int32Array;
}

export class Comparison {
  readonly compared: Compared;
  readonly old: Half;
  readonly new: Half;
  /** The change that is shown. */
  chosen: number | null = null;

  constructor(old: Container<Header>, compared: Compared, program: Program, path: Path) {
    this.compared = compared;
    const before = new Program(old);
    this.old = this.#half(before, new Path(before), 'old');
    this.new = this.#half(program, path, 'new');
    follow(this.old, this.new, this.#shifted('old'));
    follow(this.new, this.old, this.#shifted('new'));
    // Both stand in one space.
    this.old.path.embrace(path);
    path.embrace(this.old.path);
  }

  /** How many changes there are; those that are not listed count as one. */
  get count(): number {
    return this.compared.changes.length + (this.compared.rest === undefined ? 0 : 1);
  }

  /** Executed blocks of a change: from and to, by seq. */
  runs(change: number, side: Side): [number, number][] {
    const of: Fields = this.compared.changes[change] ?? this.compared.rest ?? {};
    return (of[`${side}_blocks`] ?? []) as [number, number][];
  }

  /** The change of an executed block of the new program, if it is in one. */
  changeAt(index: number): number | null {
    const change = this.new.changes[this.new.program.rowOf(index)]!;
    return change === 0 ? null : change - 1;
  }

  /** The lines of the change that is shown, the old program's first. */
  chosenLines(deviation: number, colour: number): Lines[] {
    const { chosen } = this;
    if (chosen === null) {
      return [];
    }
    return (['old', 'new'] as const).map((side) => {
      const rows = new Set<number>();
      this.#each(chosen, side, this[side].program, (row) => rows.add(row));
      const lines = new Lines(this[side].path, deviation, (row) => !rows.has(row));
      lines.colours.fill(colour);
      if (side === 'old') {
        lines.dashes = new Uint8Array(lines.count).fill(Dash.Long);
      }
      return lines;
    });
  }

  #each(change: number, side: Side, program: Program, give: (row: number) => void): void {
    for (const [from, to] of this.runs(change, side)) {
      const end = Math.min(to - program.from, program.count - 1);
      for (let index = Math.max(from - program.from, 0); index <= end; index += 1) {
        give(program.rowOf(index));
      }
    }
  }

  #half(program: Program, path: Path, side: Side): Half {
    const fates = new Uint8Array(program.rows);
    const changes = new Int32Array(program.rows);
    for (let change = 0; change < this.count; change += 1) {
      const fate = this.#moves(change) ? Fate.Moved : Fate.Values;
      this.#each(change, side, program, (row) => {
        fates[row] = Math.max(fates[row]!, fate);
        changes[row] ||= change + 1;
      });
    }
    return { program, path, fates, changes };
  }

  /** Whether lines run elsewhere by a change. */
  #moves(change: number): boolean {
    const kind = this.compared.changes[change]?.['kind'] ?? 'position';
    return kind === 'position' || kind === 'added' || kind === 'removed';
  }

  /** By row: which of X, Y, Z its changes take elsewhere, a bit each. */
  #shifted(side: Side): Uint8Array {
    const { program } = this[side];
    const shifted = new Uint8Array(program.rows);
    for (let change = 0; change < this.count; change += 1) {
      if (this.#moves(change)) {
        const axis = 'XYZ'.indexOf(String(this.compared.changes[change]?.['what'] ?? '?'));
        this.#each(change, side, program, (row) => (shifted[row]! |= axis < 0 ? 7 : 1 << axis));
      }
    }
    return shifted;
  }
}

/** Lines behind a shifted one, along other axes, run elsewhere too, unless the other program has the same line. */
function follow(half: Half, other: Half, shifted: Uint8Array): void {
  const { program, path, fates } = half;
  const moved = program.header.shapes.map((shape) => {
    const axes = (shape.m?.['axes'] ?? []) as string[];
    return axes.reduce((bits, letter) => bits | (1 << 'XYZ'.indexOf(letter)), 0) & 7;
  });
  const elsewhere = new Uint8Array(program.rows);
  let ends: Ends | undefined;
  for (let row = 1; row < program.rows; row += 1) {
    const axes = moved[program.shape[row]!]!;
    const before = elsewhere[program.before[row]!]!;
    elsewhere[row] = (before & ~axes) | (shifted[row]! & axes);
    if (before !== 0 && fates[row] !== Fate.Moved && path.hasLine(row)) {
      ends ??= new Ends(other);
      fates[row] = ends.has(half, row) ? fates[row]! : Fate.Moved;
    }
  }
}

/** The lines of a path, found by their ends. */
class Ends {
  readonly #half: Half;
  readonly #mask: number;
  /** One more than a row, at its hash or behind. */
  readonly #slots: Int32Array;

  constructor(half: Half) {
    this.#half = half;
    const size = 2 ** Math.ceil(Math.log2(2 * half.path.rows.length + 2));
    this.#mask = size - 1;
    this.#slots = new Int32Array(size);
    for (const row of half.path.rows) {
      let at = this.#hash(endsOf(half, row));
      while (this.#slots[at] !== 0) {
        at = (at + 1) & this.#mask;
      }
      this.#slots[at] = row + 1;
    }
  }

  has(half: Half, row: number): boolean {
    const wanted = endsOf(half, row);
    for (let at = this.#hash(wanted); this.#slots[at] !== 0; at = (at + 1) & this.#mask) {
      const found = this.#slots[at]! - 1;
      const same = endsOf(this.#half, found).every((value, i) => value === wanted[i]);
      if (same && half.path.kind(row) === this.#half.path.kind(found)) {
        return true;
      }
    }
    return false;
  }

  #hash(values: number[]): number {
    return values.reduce((hash, value) => (Math.imul(hash, 31) + value) | 0, 7) & this.#mask;
  }
}

/** Start and end of a line, in thousandths. */
function endsOf({ path }: Half, row: number): number[] {
  return [...path.start(row), ...path.point(row)].map((value) => Math.round(1000 * value));
}

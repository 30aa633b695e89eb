// What led to what holds behind a block, and what comes next: looks back and ahead, without records.

import type { Json, Shape } from './header.ts';
import type { Program } from './program.ts';

/** What comes next behind a block, as indices. */
export interface Ahead {
  tool: number | undefined;
  stop: number | undefined;
  rapid: number | undefined;
}

/** A jump whose counter is armed: the block that arrived there last, how many jumps are left, of how many. */
export interface Counter {
  index: number;
  left: number;
  /** Nobody knows where the page begins in the middle. */
  of: number | undefined;
}

/** The executed block that last wrote something, by its name; nothing where no block of the page did. */
export type Writers = (name: string) => number | undefined;

export class History {
  readonly #program: Program;
  /** Places in `names`: of what each extra writes, and each shape moves. */
  readonly #byExtra: readonly number[][];
  readonly #byShape: readonly number[][];
  /** What blocks write, by the names that `cnc872c state` gives: `g0`, `m2`, `feed`, `R10`, `X`. */
  readonly #names: string[] = [];
  readonly #places = new Map<string, number>();
  /** By name: the last block that wrote it before every so many blocks, those of `ways`; -1 where none did. */
  #kept: Int32Array[] | undefined;
  readonly #moved: ReadonlySet<string>;
  readonly #tools: boolean[];
  readonly #stops: boolean[];
  readonly #jumps: boolean[];
  /** By block: whether it makes a counted jump somewhere. */
  #counted: Uint8Array | undefined;

  constructor(program: Program) {
    this.#program = program;
    const { extras, program: facts, shapes } = program.header;
    const stopsAtM01 = facts['optional_stop'] === true;
    const numbers = (value: Json | undefined): number[] => (Array.isArray(value) ? (value as number[]) : []);
    const places = (names: readonly string[]): number[] => names.map((name) => this.#place(name));
    this.#byExtra = extras.map(({ written = [] }) => places(written));
    const axesOf = ({ m }: Shape): string[] => (m?.['axes'] ?? []) as string[];
    this.#byShape = shapes.map((shape) => places(axesOf(shape)));
    const ofCycles = ({ w = {} }: Shape): string[] => Object.keys(w).filter((letter) => w[letter] === 'cycle');
    this.#moved = new Set(shapes.flatMap((shape) => [...axesOf(shape), ...ofCycles(shape)]));
    this.#jumps = extras.map((extra) => extra['jump'] !== undefined);
    this.#tools = extras.map((extra) => numbers(extra['m_set']).includes(6));
    this.#stops = extras.map((extra) => extra['stop'] === true || (stopsAtM01 && extra['cond_stop'] === true));
  }

  #place(name: string): number {
    let place = this.#places.get(name);
    if (place === undefined) {
      place = this.#names.push(name) - 1;
      this.#places.set(name, place);
    }
    return place;
  }

  /** Whether the program moves an axis, as far as the page shows. */
  moves(letter: string): boolean {
    return this.#moved.has(letter);
  }

  /** Whether the program changes tools. */
  get changesTools(): boolean {
    return this.#tools.includes(true);
  }

  /** Notes in `last` what the blocks of a range write. */
  #note(last: Int32Array, from: number, to: number): void {
    const program = this.#program;
    for (let index = from; index < to; index += 1) {
      const row = program.rowOf(index);
      for (const place of this.#byExtra[program.extra[row]!]!) {
        last[place] = index;
      }
      for (const place of this.#byShape[program.shape[row]!]!) {
        last[place] = index;
      }
    }
  }

  /** By name: the executed block that last wrote it, up to a block; -1 where no block of the page did. */
  #last(index: number): Int32Array {
    const { apart } = this.#program.header.ways;
    if (this.#kept === undefined) {
      const last = new Int32Array(this.#names.length).fill(-1);
      this.#kept = [last.slice()];
      for (let from = 0; from + apart <= this.#program.count; from += apart) {
        this.#note(last, from, from + apart);
        this.#kept.push(last.slice());
      }
    }
    const kept = Math.floor((index + 1) / apart);
    const last = this.#kept[kept]!.slice();
    this.#note(last, kept * apart, index + 1);
    return last;
  }

  /** The executed blocks that last wrote what is in force behind a block, by names as `cnc872c state` gives them. */
  writers(index: number): Writers {
    const last = this.#last(index);
    return (name) => {
      const place = this.#places.get(name);
      const writer = place === undefined ? -1 : last[place]!;
      return writer < 0 ? undefined : writer;
    };
  }

  /** The parameters with known values behind a block, ascending, and who wrote them; `writers`: of the block. */
  parameters(writers: Writers): [name: string, value: number, writer: number | undefined][] {
    const program = this.#program;
    const { given = {} } = program.header;
    const names = new Set([...Object.keys(given), ...this.#names.filter((name) => /^R\d/.test(name))]);
    const found: [string, number, number | undefined][] = [];
    for (const name of names) {
      const writer = writers(name);
      const value = writer === undefined ? given[name] : program.paramsOf(program.rowOf(writer))[name];
      if (typeof value === 'number') {
        found.push([name, value, writer]);
      }
    }
    return found.sort(([a], [b]) => Number(a.slice(1)) - Number(b.slice(1)));
  }

  /** The armed counters of the program and of the open calls behind a block, outermost first. */
  counters(index: number): Counter[] {
    const program = this.#program;
    const found: Counter[] = [];
    let frame = program.contextOf(index);
    // By block: the last arrival at its jump in the frame, and the first since its counter was armed.
    let jumps = new Map<number, { last: number; first: number; open: boolean }>();
    this.#counted ??= program.countedJumps();
    const counted = this.#counted;
    const leave = (): void => {
      const armed = [...jumps].filter(([, { last }]) => program.leftOf(last) !== undefined).sort(([a], [b]) => a - b);
      const counters = armed.map(([, { last, first, open }]) => ({
        index: last,
        left: program.leftOf(last)!,
        of: open && program.from > 0 ? undefined : program.leftOf(first)! + 1,
      }));
      found.unshift(...counters);
      jumps = new Map();
    };
    for (let at = counted.includes(1) ? index : -1; at >= 0; at -= 1) {
      const context = program.contextOf(at);
      while (!this.#isWithin(context, frame)) {
        leave();
        frame = program.parentOf(frame);
      }
      const row = program.rowOf(at);
      const block = program.block[row]!;
      const left = program.leftOf(at);
      // A jump without a counter leaves it as it is.
      if (context !== frame || !counted[block] || (left === undefined && this.#jumps[program.extra[row]!])) {
        continue;
      }
      const jump = jumps.get(block);
      if (jump === undefined) {
        jumps.set(block, { last: at, first: at, open: left !== undefined });
      } else if (jump.open && left === program.leftOf(jump.first)! + 1) {
        jump.first = at;
      } else {
        jump.open = false;
      }
    }
    leave();
    return found;
  }

  /** Whether a context is another one, or lies within its calls. */
  #isWithin(context: number, frame: number): boolean {
    let at = context;
    while (at > frame) {
      at = this.#program.parentOf(at);
    }
    return at === frame;
  }

  /** The known path from the program's start to before a block of the page, in mm. */
  pathBefore(index: number): number {
    const program = this.#program;
    const { apart, mm } = program.header.ways;
    const place = Math.min(Math.floor(index / apart), mm.length - 2);
    let path = mm[place]!;
    for (let at = place * apart; at < index; at += 1) {
      path += program.knownWay(program.rowOf(at));
    }
    return path;
  }

  /** The known path of the whole program, in mm. */
  get path(): number {
    const { mm } = this.#program.header.ways;
    return mm[mm.length - 1]!;
  }

  /** The next tool change, stop and rapid motion behind a block. */
  ahead(index: number): Ahead {
    const program = this.#program;
    const { shapes } = program.header;
    const next: Ahead = { tool: undefined, stop: undefined, rapid: undefined };
    for (let at = index + 1; at < program.count; at += 1) {
      const row = program.rowOf(at);
      const extra = program.extra[row]!;
      if (next.tool === undefined && this.#tools[extra]) {
        next.tool = at;
      }
      if (next.stop === undefined && this.#stops[extra]) {
        next.stop = at;
      }
      if (next.rapid === undefined && shapes[program.shape[row]!]!.m?.['type'] === 'rapid') {
        next.rapid = at;
      }
      if (next.tool !== undefined && next.stop !== undefined && next.rapid !== undefined) {
        break;
      }
    }
    return next;
  }
}

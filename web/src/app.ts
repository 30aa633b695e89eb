// What the page shows: the program, the block in hand, what is chosen. Everything that looks at it listens to its events.

import type { Container } from './data/columns.ts';
import { Comparison } from './data/compared.ts';
import type { Header } from './data/header.ts';
import { History } from './data/history.ts';
import { Program } from './data/program.ts';
import { Text } from './data/text.ts';
import { Times } from './data/times.ts';
import type { Place } from './panel.ts';
import { Path } from './scene/path.ts';

export const COLOURS = ['motion', 'feed', 'velocity', 'tool', 'set', 'time', 'depth', 'change'] as const;
export type ColourBy = (typeof COLOURS)[number];

/** What is shown besides the path. */
export interface Shown {
  red: boolean;
  yellow: boolean;
  numbers: boolean;
  equidistant: boolean;
  rapids: boolean;
  grid: boolean;
  /** The path of the old program. */
  old: boolean;
}

/** What is left out of the picture by hand. */
export interface Filter {
  /** Tools that are hidden; null stands for none in the spindle. */
  tools: Set<number | null>;
  /** Units that are hidden: `0` the main program, else file and L. */
  units: Set<string>;
  /** Only executed blocks from … to …, as indices. */
  from: number;
  to: number;
}

interface Events {
  select: { index: number | null; by: 'script' | 'user' | 'play' };
  data: undefined;
  colour: undefined;
  shown: undefined;
  filter: undefined;
  language: undefined;
  theme: undefined;
  measure: undefined;
  stale: undefined;
  together: undefined;
  change: undefined;
}

export class App {
  program!: Program;
  path!: Path;
  text!: Text;
  times: Times | undefined;
  /** On a page of `compare`. */
  comparison: Comparison | undefined;
  current: number | null = null;
  /** Whether the picture is that of an earlier text, because the program cannot be executed now. */
  stale = false;
  /** Rows of all executions of the block in hand, when all of them are shown; else nothing. */
  together: readonly number[] = [];
  colourBy: ColourBy = 'motion';
  readonly shown: Shown = {
    red: true,
    yellow: true,
    numbers: true,
    equidistant: true,
    rapids: true,
    grid: true,
    old: true,
  };
  filter: Filter = { tools: new Set(), units: new Set(), from: 0, to: 0 };
  /** Units by what led to a block. */
  readonly #units = new Map<number, string>();
  #history: History | undefined;
  readonly #listeners = new Map<keyof Events, ((value: never) => void)[]>();

  /** `old`: the data of the program that it is compared with. */
  constructor(data: Container<Header>, old?: Container<Header>) {
    this.#read(data);
    const { compared } = this.header;
    if (old !== undefined && compared !== undefined) {
      this.comparison = new Comparison(old, compared, this.program, this.path);
      this.colourBy = 'change';
    }
  }

  /** What the path can be coloured by. */
  get colours(): ColourBy[] {
    return COLOURS.filter((by) => by !== 'change' || this.comparison !== undefined);
  }

  #read(data: Container<Header>): void {
    this.program = new Program(data);
    this.comparison = undefined;
    this.#units.clear();
    this.#history = undefined;
    this.path = new Path(this.program);
    this.text = new Text(data, this.program);
    this.times = data.has('time.code') ? new Times(data, this.program) : undefined;
    this.filter = { tools: new Set(), units: new Set(), from: 0, to: Math.max(this.program.count - 1, 0) };
  }

  /**
   * Shows other data, such as those of the program after a change. What is in hand, or the block at `at`, stays in hand. Data
   * without a block take the place of others only when these are of another program: half a word is none to lose a picture for.
   */
  replace(data: Container<Header>, at?: Place): void {
    if (data.header.count === 0 && this.program.count > 0 && data.header.program.name === this.header.program.name) {
      this.age();
      return;
    }
    const before = this.current;
    const place = before === null ? undefined : this.place(before);
    const { tools, units, from, to } = this.filter;
    const last = this.program.count - 1;
    this.#read(data);
    const end = this.filter.to;
    this.filter = { tools, units, from: Math.min(from, end), to: to >= last ? end : Math.min(to, end) };
    this.current = null;
    this.together = [];
    this.stale = false;
    this.emit('data', undefined);
    const nearest = [at, place].map((wanted) => wanted && this.#nearest(wanted, before ?? 0));
    const index = nearest.find((found) => typeof found === 'number');
    if (index !== undefined) {
      this.select(index, 'script');
      if (at !== undefined) {
        this.gather();
      }
    }
  }

  /** The data are those of an earlier text from now on. */
  age(): void {
    this.stale = true;
    this.emit('stale', undefined);
  }

  /** Takes the block at a place in hand, unless one of its executions is: the one nearest to what was in hand. */
  follow(place: Place): void {
    const current = this.current === null ? undefined : this.place(this.current);
    if (current?.file === place.file && current.line === place.line) {
      this.gather();
      return;
    }
    const nearest = this.#nearest(place, this.current ?? 0);
    if (nearest !== null) {
      this.select(nearest, 'script');
      this.gather();
    }
  }

  /** Shows a change, and takes its first block in hand: of the new program, where it has one. */
  choose(change: number | null): void {
    const { comparison } = this;
    if (comparison !== undefined) {
      comparison.chosen = change;
      const [first] = change === null ? [] : comparison.runs(change, 'new');
      this.select(first === undefined ? (change === null ? this.current : null) : first[0] - this.program.from);
      this.emit('change', undefined);
    }
  }

  /** Shows all executions of the block in hand, until another block is taken. */
  gather(): void {
    const { current, program } = this;
    const executions = current === null ? [] : program.executionsOf(this.place(current).block);
    this.together = [...new Set(executions.map((index) => program.rowOf(index)))];
    this.emit('together', undefined);
  }

  /** Of the executions of the block at a place, the one nearest to another block. */
  #nearest({ file, line }: Place, index: number): number | null {
    let nearest: number | null = null;
    for (const execution of this.program.executionsAt(file, line)) {
      if (nearest === null || Math.abs(execution - index) < Math.abs(nearest - index)) {
        nearest = execution;
      }
    }
    return nearest;
  }

  on<E extends keyof Events>(event: E, listener: (value: Events[E]) => void): void {
    const listeners = this.#listeners.get(event) ?? [];
    listeners.push(listener);
    this.#listeners.set(event, listeners);
  }

  emit<E extends keyof Events>(event: E, value: Events[E]): void {
    for (const listener of this.#listeners.get(event) ?? []) {
      (listener as (value: Events[E]) => void)(value);
    }
  }

  /** Who wrote what is in force. */
  get history(): History {
    this.#history ??= new History(this.program);
    return this.#history;
  }

  get header(): Header {
    return this.program.header;
  }

  /** Takes an executed block in hand. */
  select(index: number | null, by: 'script' | 'user' | 'play' = 'user'): void {
    if (index !== this.current) {
      if (this.together.length > 0 && (index === null || !this.together.includes(this.program.rowOf(index)))) {
        this.together = [];
        this.emit('together', undefined);
      }
      this.current = index;
      this.emit('select', { index, by });
    }
  }

  /** Where the text of an executed block stands. */
  place(index: number): { seq: number; file: number; line: number; block: number } {
    const block = this.program.block[this.program.rowOf(index)]!;
    return { seq: this.program.from + index, file: this.program.fileOf(block), line: this.program.line[block]!, block };
  }

  /** The step to the block before or after the one in hand. */
  step(by: number): void {
    const { count } = this.program;
    if (count > 0) {
      const from = this.current ?? (by > 0 ? -1 : count);
      this.select(Math.min(Math.max(from + by, 0), count - 1));
    }
  }

  /** The step to another execution of the block in hand. */
  stepPass(by: number): void {
    if (this.current === null) {
      return;
    }
    const executions = this.program.executionsOf(this.place(this.current).block);
    const at = executions.indexOf(this.current) + by;
    if (at >= 0 && at < executions.length) {
      this.select(executions[at]!);
    }
  }

  /** Whether a filter leaves an executed block out of the picture. */
  isHidden(index: number): boolean {
    const { filter, program } = this;
    if (index < filter.from || index > filter.to) {
      return true;
    }
    if (filter.tools.size > 0) {
      const tool = program.header.states[program.state[program.rowOf(index)]!]!['tool'];
      if (filter.tools.has(typeof tool === 'number' ? tool : null)) {
        return true;
      }
    }
    return filter.units.size > 0 && filter.units.has(this.unitOf(index));
  }

  /** Whether anything is filtered. */
  get isFiltered(): boolean {
    const { tools, units, from, to } = this.filter;
    return tools.size > 0 || units.size > 0 || from > 0 || to < this.program.count - 1 || !this.shown.rapids;
  }

  /** By row: whether the picture has an execution of it that no filter leaves out. */
  shownRows(): Uint8Array {
    const { program } = this;
    const shown = new Uint8Array(program.rows);
    for (let index = 0; index < program.count; index += 1) {
      if (!this.isHidden(index)) {
        shown[program.rowOf(index)] = 1;
      }
    }
    return shown;
  }

  /** The unit that an executed block belongs to: empty for the main program, else by what the last call called. */
  unitOf(index: number): string {
    const context = this.program.contextOf(index);
    let unit = this.#units.get(context);
    if (unit === undefined) {
      const calls = this.program.calls(index);
      const last = calls[calls.length - 1];
      unit = last === undefined ? '' : `${last['by'] === 'G71' ? 'G71' : 'G72'} L${String(last['l'])}`;
      this.#units.set(context, unit);
    }
    return unit;
  }
}

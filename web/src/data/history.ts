// Who wrote what is in force at a block, and what comes next: one look back and one ahead, without records.

import type { Json } from './header.ts';
import type { Program } from './program.ts';

/** What a block writes, by extra: names as `G1`, `M8`, `F`. */
const WORDS: readonly [field: string, name: string][] = [
  ['f_set', 'F'],
  ['s_set', 'S'],
  ['t_set', 'T'],
  ['d_set', 'D'],
  ['h_set', 'H'],
  ['p_set', 'P'],
];

/** What comes next behind a block, as indices. */
export interface Ahead {
  tool: number | undefined;
  stop: number | undefined;
  rapid: number | undefined;
}

export class History {
  readonly #program: Program;
  /** By extra: what is written, and whether parameters are. */
  readonly #written: string[][];
  readonly #params: boolean[];
  readonly #tools: boolean[];
  readonly #stops: boolean[];

  constructor(program: Program) {
    this.#program = program;
    const { extras, program: facts } = program.header;
    const stopsAtM01 = facts['optional_stop'] === true;
    const numbers = (value: Json | undefined): number[] => (Array.isArray(value) ? (value as number[]) : []);
    this.#written = extras.map((extra) => [
      ...numbers(extra['g_set']).map((code) => `G${code}`),
      ...numbers(extra['m_set']).map((code) => `M${code}`),
      ...WORDS.filter(([field]) => extra[field] === true).map(([, name]) => name),
    ]);
    this.#params = extras.map((extra) => Array.isArray(extra['params']));
    this.#tools = extras.map((extra) => numbers(extra['m_set']).includes(6));
    this.#stops = extras.map((extra) => extra['stop'] === true || (stopsAtM01 && extra['cond_stop'] === true));
  }

  /** The executed blocks that last wrote these, up to a block; those that nobody wrote are left out. */
  writers(index: number, names: ReadonlySet<string>): Map<string, number> {
    const program = this.#program;
    const found = new Map<string, number>();
    for (let at = index; at >= 0 && found.size < names.size; at -= 1) {
      for (const name of this.#written[program.extra[program.rowOf(at)]!]!) {
        if (names.has(name) && !found.has(name)) {
          found.set(name, at);
        }
      }
    }
    return found;
  }

  /** The parameters that the program wrote up to a block, with their values and who wrote them, ascending. */
  parameters(index: number): [name: string, value: number, at: number][] {
    const program = this.#program;
    const found = new Map<string, [string, number, number]>();
    if (this.#params.includes(true)) {
      for (let at = index; at >= 0; at -= 1) {
        const row = program.rowOf(at);
        if (this.#params[program.extra[row]!]) {
          for (const [name, value] of Object.entries(program.paramsOf(row))) {
            if (!found.has(name)) {
              found.set(name, [name, value as number, at]);
            }
          }
        }
      }
    }
    return [...found.values()].sort(([a], [b]) => Number(a.slice(1)) - Number(b.slice(1)));
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

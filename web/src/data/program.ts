// An executed program: what each executed block was, as the page's data holds it, and its record made again.

import { Texts, type Container, type Numbers } from './columns.ts';
import type { Fields, Header, Json, Shape } from './header.ts';
import { micro } from './numbers.ts';

/** What a shape says, for quick reading: a bit for each axis of the machine. */
interface ShapeBits {
  known: number;
  coded: number;
}

/** The text of a comment: without its quotes, and without blanks at its ends. */
function unquoted(token: string): string {
  const inner = token.startsWith('"')
    ? token.slice(1).replace(/"$/, '')
    : token.replace(/^[“”„]/, '').replace(/["“”„]$/, '');
  return inner.replace(/^[ \t]+|[ \t]+$/g, '');
}

/** An executed program. Executed blocks are counted from the first in the page: `index` is `seq - from`. */
export class Program {
  readonly header: Header;
  /** Letters of the axes, in the order of the machine. */
  readonly letters: string[];
  /** Places of the first three linear axes. */
  readonly linear: number[];
  /** How many rows: different executions of blocks. Row 0 is what holds before the first block. */
  readonly rows: number;
  /** By row: which block of the text. */
  readonly block: Numbers;
  /** By row: the row whose positions are those before it. */
  readonly before: Int32Array;
  readonly state: Numbers;
  readonly extra: Numbers;
  readonly shape: Numbers;
  /** By row: F in thousandths. */
  readonly feed: Numbers;
  /** Positions by axis and row, in parts of a millimetre or degree. Unknown ones hold where the axis is first known. */
  readonly position: Numbers[];
  /** Parts of a millimetre or degree, by axis. */
  readonly per: number[];
  /** Vectors from start to centre along the axes of the plane, of rows whose shape has `r`, in parts of a millimetre. */
  readonly center: [Numbers, Numbers];
  readonly centerPer: number;
  /** By row: where its vector is in `center`, -1 without one. Absent when no row has one. */
  readonly centerAt: Int32Array | undefined;
  /** By block: number, line and column of its N. */
  readonly n: Numbers;
  readonly line: Numbers;
  readonly column: Numbers;
  /** By file: its first block; one more at the end. */
  readonly firstBlock: number[];

  /** The comments of all files' blocks, as written. */
  readonly comments: Texts;
  /** By block: how many comments are its own. */
  readonly #own: Numbers;
  #firstComment: Int32Array | undefined;
  readonly #params: Numbers;
  #paramAt: Int32Array | undefined;
  readonly #rowOf: Numbers;
  readonly #contextOf: Numbers;
  readonly #left: Numbers;
  readonly #contexts: { parent: Numbers; block: Numbers; call: Numbers; pass: Numbers; of: Numbers };
  readonly #bits: ShapeBits[];
  #straight: boolean | undefined;
  #lastIndex: Int32Array | undefined;
  #firstIndex: Int32Array | undefined;
  #byPlace: { keyOf: Int32Array; start: Int32Array; members: Int32Array } | undefined;

  constructor(data: Container<Header>) {
    const header = data.header;
    this.header = header;
    this.letters = header.program.axes.map((axis) => axis.letter);
    this.linear = header.program.axes.flatMap((axis, place) => (axis.kind === 'linear' ? [place] : [])).slice(0, 3);
    this.block = data.take('row.block');
    this.rows = this.block.length;
    const back = data.take('row.before');
    this.before = new Int32Array(this.rows);
    for (let row = 0; row < this.rows; row += 1) {
      this.before[row] = Math.max(row - 1 - back[row]!, 0);
    }
    this.state = data.take('row.state');
    this.extra = data.take('row.extra');
    this.shape = data.take('row.shape');
    this.feed = data.take('row.feed');
    const bits = (letters: string | undefined): number =>
      this.letters.reduce((sum, letter, axis) => (letters?.includes(letter) ? sum | (1 << axis) : sum), 0);
    this.#bits = header.shapes.map((shape) => ({ known: bits(shape.k), coded: bits(shape.c) }));
    this.per = this.letters.map((letter) => header.per[`pos.${letter}`] ?? 1000);
    // Axes that are never known share their zeros.
    const nowhere = new Uint8Array(this.rows);
    const known = this.#bits.reduce((sum, shape) => sum | shape.known, 0);
    this.position = this.letters.map((letter, axis) =>
      known & (1 << axis) ? this.#readPositions(data.take(`pos.${letter}`), axis) : nowhere,
    );
    this.center = [data.take('arc.0'), data.take('arc.1')];
    this.centerPer = header.per['arc'] ?? 1000;
    this.centerAt = this.#placeCenters();
    this.n = data.take('block.n');
    this.line = data.take('block.line');
    this.column = data.take('block.column');
    this.firstBlock = [0];
    for (const file of header.files) {
      this.firstBlock.push(this.firstBlock[this.firstBlock.length - 1]! + file.blocks);
    }
    this.comments = new Texts(data.text('comments'), data.take('comment.bytes'));
    this.#own = data.take('block.own');
    this.#params = data.take('row.param');
    this.#rowOf = data.take('seq.row');
    this.#contextOf = data.take('seq.context');
    this.#left = data.take('seq.left');
    this.#contexts = {
      parent: data.take('context.parent'),
      block: data.take('context.block'),
      call: data.take('context.call'),
      pass: data.take('context.pass'),
      of: data.take('context.of'),
    };
  }

  /** The column of an axis holds the values that are new; the others stand where they stood before. */
  #readPositions(coded: Numbers, axis: number): Numbers {
    const bit = 1 << axis;
    const bits = this.#bits;
    const wide = coded instanceof Float64Array;
    const positions: Numbers = wide ? new Float64Array(this.rows) : new Int32Array(this.rows);
    let next = 0;
    for (let row = 0; row < this.rows; row += 1) {
      const shape = bits[this.shape[row]!]!;
      if (shape.coded & bit) {
        positions[row] = coded[next]!;
        next += 1;
      } else if (shape.known & bit) {
        positions[row] = positions[this.before[row]!]!;
      }
    }
    // An unknown coordinate is drawn where the axis is first known to stand; behind the last, where it last stood.
    let known: number | undefined;
    for (let row = this.rows - 1; row >= 0; row -= 1) {
      if (bits[this.shape[row]!]!.known & bit) {
        known = positions[row]!;
      } else if (known !== undefined) {
        positions[row] = known;
      }
    }
    if (known !== undefined) {
      for (let row = this.rows - 1; row >= 0 && !(bits[this.shape[row]!]!.known & bit); row -= 1) {
        positions[row] = this.#lastKnown(positions, bit);
      }
    }
    return positions;
  }

  #lastKnown(positions: Numbers, bit: number): number {
    for (let row = this.rows - 1; row >= 0; row -= 1) {
      if (this.#bits[this.shape[row]!]!.known & bit) {
        return positions[row]!;
      }
    }
    return 0;
  }

  #placeCenters(): Int32Array | undefined {
    if (this.center[0].length === 0) {
      return undefined;
    }
    const at = new Int32Array(this.rows).fill(-1);
    const arcs = this.header.shapes.map((shape) => shape.r !== undefined);
    let next = 0;
    for (let row = 0; row < this.rows; row += 1) {
      if (arcs[this.shape[row]!]) {
        at[row] = next;
        next += 1;
      }
    }
    return at;
  }

  /** How many executed blocks the page holds. */
  get count(): number {
    return this.header.count;
  }

  get from(): number {
    return this.header.from;
  }

  /** The row of an executed block. */
  rowOf(index: number): number {
    return this.#rowOf.length > 0 ? this.#rowOf[index]! : index + 1;
  }

  shapeOf(row: number): Shape {
    return this.header.shapes[this.shape[row]!]!;
  }

  /** Whether the page holds the whole program. */
  get isWhole(): boolean {
    return this.from === 0 && this.count === this.header.blocks;
  }

  /** Whether a row moves rotary axes only: its velocities are degrees a minute. */
  turns(row: number): boolean {
    return this.turnsBy(this.shape[row]!);
  }

  /** The same by a shape's index. */
  turnsBy(shape: number): boolean {
    const moved = (this.header.shapes[shape]!.m?.['axes'] ?? []) as string[];
    const { axes } = this.header.program;
    return (
      moved.length > 0 && moved.every((letter) => axes.some((axis) => axis.letter === letter && axis.kind === 'rotary'))
    );
  }

  /** What the velocities of a row count. */
  feedUnit(row: number): 'deg/min' | 'mm/min' {
    return this.turns(row) ? 'deg/min' : 'mm/min';
  }

  isKnown(row: number, axis: number): boolean {
    return (this.#bits[this.shape[row]!]!.known & (1 << axis)) !== 0;
  }

  /** Where an axis stands after a row. */
  positionOf(row: number, axis: number): number {
    return this.position[axis]![row]! / this.per[axis]!;
  }

  /** The last executed block that a row stands for. */
  lastIndexOf(row: number): number {
    if (this.#rowOf.length === 0) {
      return row - 1;
    }
    if (this.#lastIndex === undefined) {
      this.#lastIndex = new Int32Array(this.rows).fill(-1);
      for (let index = 0; index < this.count; index += 1) {
        this.#lastIndex[this.#rowOf[index]!] = index;
      }
    }
    return this.#lastIndex[row]!;
  }

  /** The first executed block that a row stands for. */
  firstIndexOf(row: number): number {
    if (this.#rowOf.length === 0) {
      return row - 1;
    }
    if (this.#firstIndex === undefined) {
      this.#firstIndex = new Int32Array(this.rows).fill(-1);
      for (let index = this.count - 1; index >= 0; index -= 1) {
        this.#firstIndex[this.#rowOf[index]!] = index;
      }
    }
    return this.#firstIndex[row]!;
  }

  /** The file of a block. */
  fileOf(block: number): number {
    let file = 0;
    while (block >= this.firstBlock[file + 1]!) {
      file += 1;
    }
    return file;
  }

  /** All executions of the blocks that begin in a line of a file, ascending, as indices. */
  executionsAt(file: number, line: number): number[] {
    const block = this.blockAt(file, line);
    return block === undefined ? [] : this.executionsOf(block);
  }

  /** The first block whose N stands in a line of a file. */
  blockAt(file: number, line: number): number | undefined {
    let low = this.firstBlock[file] ?? 0;
    let high = this.firstBlock[file + 1] ?? 0;
    const end = high;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.line[middle]! < line) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low < end && this.line[low] === line ? low : undefined;
  }

  /** Does what the first question about executions would wait for. */
  prepare(): void {
    if (!this.#isStraight) {
      this.#byPlace ??= this.#groupByPlace();
    }
  }

  /** Whether each block of the text is executed once, in the order of the text: nothing need be looked up. */
  get #isStraight(): boolean {
    if (this.#straight === undefined) {
      this.#straight = this.#rowOf.length === 0 && this.n.length === this.count && this.firstBlock.length === 2;
      for (let row = 1; row < this.rows && this.#straight; row += 1) {
        this.#straight = this.block[row] === row - 1;
      }
    }
    return this.#straight;
  }

  /** The executions of a row, ascending. */
  executionsOfRow(row: number): number[] {
    return this.executionsOf(this.block[row]!).filter((index) => this.rowOf(index) === row);
  }

  /** What led to an executed block, as a number: blocks with the same number have the same calls. */
  contextOf(index: number): number {
    return this.#contextOf[index] ?? 0;
  }

  /** All executions of a block, and of those that begin in its line: the same block is the same file and line. */
  executionsOf(block: number): number[] {
    return Array.from(this.#executions(block));
  }

  /** Which of the executions of its block an executed block is: how many come before it, and how many there are. */
  passOf(index: number): { before: number; all: number } {
    const executions = this.#executions(this.block[this.rowOf(index)]!);
    return { before: executions.indexOf(index), all: executions.length };
  }

  #executions(block: number): ArrayLike<number> & { indexOf(index: number): number } {
    if (this.#isStraight) {
      const line = this.line[block];
      let [first, end] = [block, block + 1];
      while (first > 0 && this.line[first - 1] === line) {
        first -= 1;
      }
      while (end < this.count && this.line[end] === line) {
        end += 1;
      }
      return Array.from({ length: end - first }, (_, place) => first + place);
    }
    this.#byPlace ??= this.#groupByPlace();
    const { keyOf, start, members } = this.#byPlace;
    const key = keyOf[block]!;
    return members.subarray(start[key]!, start[key + 1]!);
  }

  #groupByPlace(): { keyOf: Int32Array; start: Int32Array; members: Int32Array } {
    const blocks = this.n.length;
    const keyOf = new Int32Array(blocks);
    let keys = -1;
    for (let file = 0; file + 1 < this.firstBlock.length; file += 1) {
      let line = -1;
      for (let block = this.firstBlock[file]!; block < this.firstBlock[file + 1]!; block += 1) {
        if (this.line[block] !== line) {
          line = this.line[block]!;
          keys += 1;
        }
        keyOf[block] = keys;
      }
    }
    const start = new Int32Array(keys + 2);
    for (let index = 0; index < this.count; index += 1) {
      start[keyOf[this.block[this.rowOf(index)]!]! + 1]! += 1;
    }
    for (let key = 0; key <= keys; key += 1) {
      start[key + 1]! += start[key]!;
    }
    const next = start.slice();
    const members = new Int32Array(this.count);
    for (let index = 0; index < this.count; index += 1) {
      const key = keyOf[this.block[this.rowOf(index)]!]!;
      members[next[key]!] = index;
      next[key]! += 1;
    }
    return { keyOf, start, members };
  }

  /** The G functions in force behind an executed block, by group. */
  heldBehind(index: number): (number | null)[] {
    const state = this.header.states[this.state[this.rowOf(index)]!]!;
    return state.held ?? (state['g'] as (number | null)[]);
  }

  /** What led to the block with the last call of a context. */
  parentOf(context: number): number {
    return this.#contexts.parent[context - 1] ?? 0;
  }

  /** The counter of the jump that an executed block makes; nothing of others. */
  leftOf(index: number): number | undefined {
    const left = this.#left[index] ?? 0;
    return left > 0 ? left - 1 : undefined;
  }

  /** By block: 1 where it makes a counted jump somewhere. */
  countedJumps(): Uint8Array {
    const counted = new Uint8Array(this.n.length);
    for (let index = 0; index < this.#left.length; index += 1) {
      if (this.#left[index]! > 0) {
        counted[this.block[this.rowOf(index)]!] = 1;
      }
    }
    return counted;
  }

  /** The calls that led to an executed block, outermost first. */
  calls(index: number): Fields[] {
    const calls: Fields[] = [];
    let context = this.#contextOf[index] ?? 0;
    const contexts = this.#contexts;
    while (context > 0) {
      const at = context - 1;
      const block = contexts.block[at]!;
      const call = this.header.calls[contexts.call[at]!]!;
      calls.push({
        by: call.by,
        l: call.l,
        file: this.fileOf(block),
        n: this.n[block]!,
        line: this.line[block]!,
        pass: contexts.pass[at]!,
        of: contexts.of[at]!,
      });
      context = contexts.parent[at]!;
    }
    return calls.reverse();
  }

  /** The record of an executed block, as the block stream has it. */
  record(index: number): Fields {
    const row = this.rowOf(index);
    const block = this.block[row]!;
    const record: Fields = {
      kind: 'block',
      seq: this.from + index,
      n: this.n[block]!,
      file: this.fileOf(block),
      line: this.line[block]!,
      column: this.column[block]!,
    };
    const calls = this.calls(index);
    if (calls.length > 0) {
      record['calls'] = calls;
    }
    const shape = this.shapeOf(row);
    const { held: _held, ...state } = this.header.states[this.state[row]!]!;
    const {
      motion: about,
      written: _written,
      ...extra
    } = this.header.extras[this.extra[row]!]! as Fields & { motion?: Fields };
    Object.assign(record, structuredClone(state), structuredClone(extra));
    if (Array.isArray(extra['params'])) {
      record['params'] = this.paramsOf(row);
    }
    const comments = this.commentsOf(block);
    if (comments.length > 0) {
      record['comments'] = comments;
    }
    const left = this.leftOf(index);
    if (left !== undefined) {
      (record['jump'] as Fields)['left'] = left;
    }
    if (this.from + index === 0) {
      record['first_block'] = true;
    }
    if (this.header.whole && this.from + index === this.header.blocks - 1) {
      record['last_block'] = true;
    }
    if ('feed_unit' in state) {
      record['feed'] = this.feed[row]! / 1000;
    }
    const position = this.#values(row, shape.k);
    if (Object.keys(position).length > 0) {
      record['position'] = position;
    }
    if (shape.m !== undefined) {
      record['motion'] = { ...this.motion(row, shape), ...structuredClone(about) };
    }
    return record;
  }

  /** The comments of a block, without their quotes; empty ones left out. */
  commentsOf(block: number): string[] {
    const own = this.#own[block] ?? 0;
    if (own === 0) {
      return [];
    }
    if (this.#firstComment === undefined) {
      this.#firstComment = new Int32Array(this.#own.length);
      for (let at = 1; at < this.#own.length; at += 1) {
        this.#firstComment[at] = this.#firstComment[at - 1]! + this.#own[at - 1]!;
      }
    }
    const first = this.#firstComment[block]!;
    return Array.from({ length: own }, (_, place) => unquoted(this.comments.get(first + place))).filter(
      (text) => text !== '',
    );
  }

  /** The parameters that a row writes. */
  paramsOf(row: number): Fields {
    const names = (this.header.extras[this.extra[row]!]!['params'] ?? []) as string[];
    if (this.#paramAt === undefined) {
      const counts = this.header.extras.map((extra) => (Array.isArray(extra['params']) ? extra['params'].length : 0));
      this.#paramAt = new Int32Array(this.rows);
      let next = 0;
      for (let at = 0; at < this.rows; at += 1) {
        this.#paramAt[at] = next;
        next += counts[this.extra[at]!]!;
      }
    }
    const first = this.#paramAt[row]!;
    return Object.fromEntries(names.map((name, place) => [name, this.#params[first + place]! / 1000]));
  }

  #values(row: number, letters: string | undefined): Fields {
    const values: Fields = {};
    for (const letter of letters ?? '') {
      values[letter] = this.positionOf(row, this.letters.indexOf(letter));
    }
    return values;
  }

  /** Vector from start to centre of an arc, along the axes of its plane, in millimetres. */
  toCenter(row: number): [number, number] {
    const at = this.centerAt?.[row] ?? -1;
    return [this.center[0][at]! / this.centerPer, this.center[1][at]! / this.centerPer];
  }

  /** The angle that an arc turns through, in radians, positive; negative for clockwise ones. */
  sweep(row: number, shape: Shape): number {
    const [u, v] = [this.letters.indexOf(shape.r![0]!), this.letters.indexOf(shape.r![1]!)];
    const before = this.before[row]!;
    const [toU, toV] = this.toCenter(row);
    const endU = this.positionOf(row, u) - this.positionOf(before, u) - toU;
    const endV = this.positionOf(row, v) - this.positionOf(before, v) - toV;
    // In whole millionths, so that an end on the ray of the start is found.
    const [fromU, fromV, atU, atV] = [-toU, -toV, endU, endV].map((value) => Math.round(value * 1e6)) as [
      number,
      number,
      number,
      number,
    ];
    const cross = fromU * atV - fromV * atU;
    const dot = fromU * atU + fromV * atV;
    const clockwise = shape.m?.['type'] === 'arc_cw';
    const turn = clockwise ? -Math.atan2(cross, dot) : Math.atan2(cross, dot);
    const sweep = turn <= 0 ? turn + 2 * Math.PI : turn;
    return clockwise ? -sweep : sweep;
  }

  /** The motion of a row with its numbers. */
  motion(row: number, shape: Shape): Fields {
    const motion: Fields = structuredClone(shape.m!);
    const before = this.before[row]!;
    const start = this.#values(before, shape.s);
    if (Object.keys(start).length > 0) {
      motion['start'] = start;
    }
    const sweep = shape.r === undefined ? 0 : this.sweep(row, shape);
    let arc = 0;
    if (shape.r !== undefined) {
      const [toU, toV] = this.toCenter(row);
      const radius = Math.sqrt(toU * toU + toV * toV);
      const center = (letter: string, to: number): Json =>
        micro(this.positionOf(before, this.letters.indexOf(letter)) + to);
      motion['center'] = { [shape.r[0]!]: center(shape.r[0]!, toU), [shape.r[1]!]: center(shape.r[1]!, toV) };
      motion['radius_mm'] = micro(radius);
      motion['sweep_deg'] = micro((Math.abs(sweep) * 180) / Math.PI);
      arc = radius * Math.abs(sweep);
    }
    if (shape.l !== undefined) {
      motion[`length_${shape.l}`] = micro(this.#length(row, shape, arc));
    }
    return motion;
  }

  /** The length of a row's motion as the record has it, in millimetres or degrees; 0 when it has none. */
  lengthOf(row: number): number {
    const shape = this.shapeOf(row);
    if (shape.l !== undefined) {
      const [toU, toV] = shape.r === undefined ? [0, 0] : this.toCenter(row);
      const arc = shape.r === undefined ? 0 : Math.sqrt(toU * toU + toV * toV) * Math.abs(this.sweep(row, shape));
      return micro(this.#length(row, shape, arc));
    }
    const about = this.header.extras[this.extra[row]!]!['motion'] as Fields | undefined;
    const kept = about?.['length_mm'] ?? about?.['length_deg'];
    return typeof kept === 'number' ? kept : 0;
  }

  /** The way of a row's motion in millimetres: 0 of one that has none or only turns, nothing when it is not known. */
  way(row: number): number | undefined {
    const shape = this.shapeOf(row);
    return shape.u === true || shape.m?.['length_missing'] !== undefined ? undefined : this.knownWay(row);
  }

  /** The way of a row's motion in millimetres as far as it is known. */
  knownWay(row: number): number {
    const shape = this.shapeOf(row);
    const kept = this.header.extras[this.extra[row]!]!['motion'] as Fields | undefined;
    return shape.l === 'deg' || kept?.['length_deg'] !== undefined ? 0 : this.lengthOf(row);
  }

  #length(row: number, shape: Shape, arc: number): number {
    const before = this.before[row]!;
    let sum = arc * arc;
    let others = 0;
    for (const letter of shape.a ?? '') {
      if (shape.r?.includes(letter)) {
        continue;
      }
      const axis = this.letters.indexOf(letter);
      const distance = (this.position[axis]![row]! - this.position[axis]![before]!) / this.per[axis]!;
      sum += distance * distance;
      others += 1;
    }
    return others === 0 ? arc : Math.sqrt(sum);
  }
}

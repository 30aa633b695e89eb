// The text of the program and its macrocycles. Most numbers of a block follow from its execution, so the data holds, for
// each block, a skeleton (the text with marks for numbers), and only what cannot be foretold. What is read here is written
// by src/view/text.rs.

import { Texts, type Container, type Numbers } from './columns.ts';
import type { Header } from './header.ts';
import type { Program } from './program.ts';

/** The first of the characters that stand for a number in a skeleton; they differ by how it is written. */
const FIRST_MARK = 0xe000;

/** How a number is written: with how many decimals (-1: as many as it needs), a point behind whole ones, a leading zero. */
interface Style {
  decimals: number;
  point: boolean;
  zero: boolean;
}

const STYLES: Style[] = [
  { decimals: -1, point: false, zero: true },
  { decimals: -1, point: true, zero: true },
  { decimals: -1, point: false, zero: false },
  { decimals: -1, point: true, zero: false },
  { decimals: 1, point: true, zero: true },
  { decimals: 2, point: true, zero: true },
  { decimals: 3, point: true, zero: true },
  { decimals: 1, point: true, zero: false },
  { decimals: 2, point: true, zero: false },
  { decimals: 3, point: true, zero: false },
];

/** The mark of a block number, padded with zeros to a width; the marks of wider ones follow. */
const NUMBER_MARK = FIRST_MARK + 16;

/** The mark of a comment. */
const COMMENT_MARK = FIRST_MARK + 48;

/** A number of thousandths as its style writes it. */
export function shown(thousandths: number, style: number): string {
  const { decimals, point, zero } = STYLES[style]!;
  const magnitude = Math.abs(thousandths);
  const whole = Math.floor(magnitude / 1000);
  let fraction = String(magnitude % 1000).padStart(3, '0');
  fraction = decimals >= 0 ? fraction.slice(0, decimals) : fraction.replace(/0+$/, '');
  const front = whole === 0 && !zero && fraction !== '' ? '' : String(whole);
  const dot = fraction !== '' || point ? '.' : '';
  return `${thousandths < 0 ? '-' : ''}${front}${dot}${fraction}`;
}

/** The text of the files, block by block and line by line. */
export class Text {
  readonly #program: Program;
  readonly #skeletons: Texts;
  /** By block: its skeleton. */
  readonly #skeleton: Numbers;
  /** By letter: what the numbers differ from what is foretold, and where the numbers of each block begin. */
  readonly #numbers = new Map<string, { values: Numbers; at: Int32Array; foretold: boolean }>();
  /** By block: the row of its first execution, 0 without one. */
  readonly #firstRow: Int32Array;
  /** By block: the first comment that stands in its text. */
  readonly #commentAt: Int32Array | undefined;
  /** By file: how many lines it has. */
  readonly lines: number[];

  constructor(data: Container<Header>, program: Program) {
    this.#program = program;
    const { foretold } = data.header;
    const skeletons = new Texts(data.text('skeletons'), data.take('skeleton.bytes'));
    this.#skeletons = skeletons;
    const blocks = program.n.length;
    this.#firstRow = new Int32Array(blocks);
    for (let row = program.rows - 1; row > 0; row -= 1) {
      this.#firstRow[program.block[row]!] = row;
    }
    this.#skeleton = this.#readSkeletons(data.take('text.skeleton'));
    const counts = new Map<string, Int32Array>();
    for (let index = 0; index < skeletons.count; index += 1) {
      countMarks(skeletons.bytes(index), (letter) => {
        const count = counts.get(letter) ?? new Int32Array(skeletons.count);
        count[index]! += 1;
        counts.set(letter, count);
      });
    }
    this.#commentAt = this.#placeComments(counts.get('"'));
    for (const [letter, count] of counts) {
      if (data.has(`text.${letter}`)) {
        const values = data.take(`text.${letter}`);
        if (foretold[letter] === 'row' && values.every((value) => value === 0)) {
          continue;
        }
        const at = new Int32Array(blocks);
        for (let block = 0, next = 0; block < blocks; block += 1) {
          at[block] = next;
          next += count[this.#skeleton[block]!]!;
        }
        this.#numbers.set(letter, { values, at, foretold: foretold[letter] === 'row' });
      }
    }
    this.lines = data.header.files.map((file, index) => {
      const last = program.firstBlock[index + 1]! - 1;
      return last < program.firstBlock[index]! ? count(file.head) + 1 : program.line[last]! + count(this.ofBlock(last));
    });
  }

  /** A skeleton is the one that stood last where a block of the same shape was executed, unless another is named. */
  #readSkeletons(column: Numbers): Numbers {
    const last = new Int32Array(this.#program.header.shapes.length);
    const skeletons = this.#skeletons.count > 0xff ? new Int32Array(column.length) : new Uint8Array(column.length);
    for (let block = 0; block < column.length; block += 1) {
      const shape = this.#program.shape[this.#firstRow[block]!]!;
      const value = column[block]!;
      const skeleton = value === 0 ? last[shape]! : value - 1;
      last[shape] = skeleton;
      skeletons[block] = skeleton;
    }
    return skeletons;
  }

  /** Where the comments of each block's text begin; nothing without comments. */
  #placeComments(counts: Int32Array | undefined): Int32Array | undefined {
    if (counts === undefined) {
      return undefined;
    }
    const { firstBlock, header } = this.#program;
    const at = new Int32Array(this.#skeleton.length);
    let first = 0;
    header.files.forEach((file, index) => {
      let next = first + file.head_comments;
      for (let block = firstBlock[index]!; block < firstBlock[index + 1]!; block += 1) {
        at[block] = next;
        next += counts[this.#skeleton[block]!]!;
      }
      first += file.comments;
    });
    return at;
  }

  /** The text of a block, from its N to the next one, with what stands between. Lines end with `\n`. */
  ofBlock(block: number): string {
    const skeleton = this.#skeletons.get(this.#skeleton[block]!);
    let text = '';
    let from = 0;
    const seen = new Map<string, number>();
    for (const { at, letter, mark } of marks(skeleton)) {
      text += skeleton.slice(from, at);
      from = at + 1;
      if (mark === COMMENT_MARK) {
        const before = seen.get('"') ?? 0;
        seen.set('"', before + 1);
        text += this.#program.comments.get(this.#commentAt![block]! + before).replace(/\r\n?/g, '\n');
        continue;
      }
      if (mark >= NUMBER_MARK) {
        text += String(this.#program.n[block]!).padStart(mark - NUMBER_MARK, '0');
        continue;
      }
      const before = seen.get(letter) ?? 0;
      seen.set(letter, before + 1);
      text += shown(this.#number(block, letter, before), mark - FIRST_MARK);
    }
    return text + skeleton.slice(from);
  }

  #number(block: number, letter: string, before: number): number {
    const numbers = this.#numbers.get(letter);
    const coded = numbers === undefined ? 0 : numbers.values[numbers.at[block]! + before]!;
    const foretold = numbers === undefined ? this.#program.header.foretold[letter] === 'row' : numbers.foretold;
    return foretold ? coded + this.#foretold(block, letter) : coded;
  }

  /** What the row of the first execution says of the number behind a letter, in thousandths. */
  #foretold(block: number, letter: string): number {
    const program = this.#program;
    const row = this.#firstRow[block]!;
    if (letter === 'F') {
      return program.feed[row]!;
    }
    if (letter === 'I' || letter === 'J') {
      const plane = program.shapeOf(row).r;
      if (plane === undefined) {
        return 0;
      }
      const swapped = program.letters.indexOf(plane[0]!) > program.letters.indexOf(plane[1]!);
      const at = program.centerAt![row]!;
      const [first, second] = [program.center[0][at]!, program.center[1][at]!];
      return Math.floor((((letter === 'I') !== swapped ? first : second) * 1000) / program.centerPer + 0.5);
    }
    const axis = program.letters.indexOf(letter);
    if (axis < 0 || !program.isKnown(row, axis)) {
      return 0;
    }
    return Math.floor((program.position[axis]![row]! * 1000) / program.per[axis]! + 0.5);
  }

  /** The text of a line of a file, from 1, in pieces: each with its block, -1 before the first. */
  line(file: number, line: number): { block: number; text: string }[] {
    const program = this.#program;
    const first = program.firstBlock[file]!;
    const end = program.firstBlock[file + 1]!;
    // The first block that begins in this line or later.
    let low = first;
    let high = end;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (program.line[middle]! < line) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    const pieces: { block: number; text: string }[] = [];
    if (low === first) {
      const text = this.#program.header.files[file]!.head.split('\n')[line - 1];
      if (text !== undefined && text !== '') {
        pieces.push({ block: -1, text });
      }
    } else {
      const before = low - 1;
      const text = this.ofBlock(before).split('\n')[line - program.line[before]!];
      if (text !== undefined && text !== '') {
        pieces.push({ block: before, text });
      }
    }
    for (let block = low; block < end && program.line[block] === line; block += 1) {
      const text = this.ofBlock(block).split('\n')[0]!;
      pieces.push({ block, text });
    }
    return pieces;
  }
}

function count(text: string): number {
  return text.split('\n').length - 1;
}

/** The marks of a skeleton, with the letters before them. */
function marks(skeleton: string): { at: number; letter: string; mark: number }[] {
  const found: { at: number; letter: string; mark: number }[] = [];
  let letter = '';
  for (let at = 0; at < skeleton.length; at += 1) {
    const code = skeleton.charCodeAt(at);
    if (code >= FIRST_MARK && code < FIRST_MARK + 64) {
      found.push({ at, letter, mark: code });
    } else if (isLetter(code)) {
      letter = skeleton[at]!;
    }
  }
  return found;
}

/** The same of a skeleton in UTF-8: the letter before each mark, `"` for comments. */
function countMarks(skeleton: Uint8Array, each: (letter: string) => void): void {
  let letter = '';
  for (let at = 0; at < skeleton.length; at += 1) {
    const code = skeleton[at]!;
    // U+E000 to U+E03F begin with these two bytes.
    if (code === 0xee && skeleton[at + 1] === 0x80) {
      each(skeleton[at + 2] === 0x80 + 48 ? '"' : letter);
    } else if (isLetter(code)) {
      letter = String.fromCharCode(code);
    }
  }
}

/** What numbers may stand behind: a capital, `=`. */
function isLetter(code: number): boolean {
  return (code >= 65 && code <= 90) || code === 61;
}

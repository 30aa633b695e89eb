// A program that the editor read as UTF-8 although it is in another code page. No VS Code here.
//
// Each letter of such a program that the editor could not read is U+FFFD in its text, and saving it would write that over
// the letter. The bytes on disk still hold the letters, and the code pages of the machines have one byte for a character:
// from the bytes and the text that the editor holds follows the text as it would be, had the file been read rightly.

import { diffArrays, diffChars } from 'diff';

import { again, isDamaged } from './encoding';

/** What a document is to the rescue. */
export interface Program {
  readonly isDirty: boolean;
  /** The encoding that it was read in and is saved in. */
  readonly encoding: string;
  getText(): string;
}

/** What the editor does for it. */
export interface Editor<P extends Program> {
  /** The bytes on disk; `undefined` when there are none. */
  read(program: P): Promise<Uint8Array | undefined>;
  write(program: P, bytes: Uint8Array): Promise<void>;
  decode(bytes: Uint8Array, encoding: string): Promise<string>;
  encode(text: string, encoding: string): Promise<Uint8Array>;
  /** The encoding that the settings say. */
  configured(program: P): string | undefined;
  /** Asks the user for the encoding. */
  ask(program: P): Promise<string | undefined>;
  /** Throws the changes of the text away. */
  revert(program: P): Promise<void>;
  /** Reads the file again in that encoding; fails when the text was changed. */
  reopen(program: P, encoding: string): Promise<void>;
  /** Gives the document this text, unsaved. */
  replace(program: P, text: string): Promise<void>;
}

/** Holds every byte: what is read in it and saved in it is the same file. */
const LOSSLESS = 'cp852';
/** How often a document is read again that somebody goes on typing in. */
const TRIES = 5;

/** Keeps damaged programs from being saved. One for all documents of an editor. */
export class Rescue<P extends Program> {
  /** Programs that are saved as UTF-8 with all their letters, and must be written in their code page then. */
  private readonly saved = new Map<P, string>();

  constructor(private readonly editor: Editor<P>) {}

  /** Reads a program again that was read in a wrong code page; what was typed meanwhile is kept. */
  async restore(program: P): Promise<void> {
    const bytes = await this.bytes(program);
    if (bytes === undefined) {
      return;
    }
    const page = again(this.editor.configured(program), program.encoding) ?? (await this.editor.ask(program));
    if (page === undefined) {
      return;
    }
    for (let tries = 1; ; tries += 1) {
      const typed = program.isDirty ? program.getText() : undefined;
      const text = typed === undefined ? undefined : restore(bytes, typed, await this.editor.decode(bytes, page));
      if (typed !== undefined) {
        if (program.getText() !== typed) {
          continue;
        }
        await this.editor.revert(program);
      }
      try {
        await this.editor.reopen(program, page);
      } catch (error) {
        // Somebody has typed just now.
        if (typed !== undefined) {
          await this.editor.replace(program, typed);
        }
        if (tries < TRIES && program.isDirty) {
          continue;
        }
        throw error;
      }
      if (text !== undefined) {
        await this.editor.replace(program, text);
      }
      return;
    }
  }

  /**
   * The text to save in place of the program's, with the letters that it lacks. `undefined`: it may be saved as it is.
   * What is saved so is UTF-8; `afterSave` then writes it in its code page.
   */
  async beforeSave(program: P): Promise<string | undefined> {
    const bytes = await this.bytes(program);
    if (bytes === undefined) {
      return undefined;
    }
    const configured = again(this.editor.configured(program), program.encoding) ?? LOSSLESS;
    const decoded = await this.editor.decode(bytes, configured);
    const page = isDamaged(decoded) ? LOSSLESS : configured;
    this.saved.set(program, page);
    return restore(bytes, program.getText(), page === configured ? decoded : await this.editor.decode(bytes, page));
  }

  /** Writes a program in its code page that was saved with the letters of `beforeSave`. */
  async afterSave(program: P): Promise<void> {
    const page = this.saved.get(program);
    if (page === undefined) {
      return;
    }
    this.saved.delete(program);
    await this.editor.write(program, await this.editor.encode(program.getText(), page));
    if (program.isDirty) {
      await this.restoreTyped(program, page);
    } else {
      await this.editor.reopen(program, page);
    }
  }

  /** Somebody types on in a program that was just written: the text is right, only the editor's encoding is not. */
  private async restoreTyped(program: P, page: string): Promise<void> {
    const text = program.getText();
    await this.editor.revert(program);
    await this.editor.reopen(program, page);
    await this.editor.replace(program, text);
  }

  /** The bytes of a program that was read in a wrong code page: its text is damaged, and not because its bytes are. */
  private async bytes(program: P): Promise<Uint8Array | undefined> {
    if (program.encoding !== 'utf8' || !isDamaged(program.getText())) {
      return undefined;
    }
    const bytes = await this.editor.read(program);
    return bytes === undefined || isUtf8(bytes) ? undefined : bytes;
  }
}

/** Whether bytes are UTF-8, so that nothing is lost when they are read as that. */
export function isUtf8(bytes: Uint8Array): boolean {
  try {
    new TextDecoder('utf-8', { fatal: true }).decode(bytes);
    return true;
  } catch {
    return false;
  }
}

/**
 * What a user has made of a file, had it been read rightly. `typed` is the text that came of reading `bytes` as UTF-8 and
 * of typing; `decoded` is what the bytes are in their code page, a character each. What was not typed is taken from
 * `decoded`.
 */
export function restore(bytes: Uint8Array, typed: string, decoded: string): string {
  const right = lines(decoded);
  const read = linesOf(bytes);
  const wrong = read.map((line) => new TextDecoder('utf-8', { ignoreBOM: true }).decode(line));
  // For a line that was moved or copied as a whole.
  const known = new Map(wrong.map((line, at) => [line, right[at] ?? line]));
  const now = lines(typed);
  const restored: string[] = [];
  let [from, to] = [0, 0];
  const parts = diffArrays(wrong, now);
  for (let at = 0; at < parts.length; at += 1) {
    const part = parts[at];
    if (part === undefined) {
      break;
    }
    if (!part.added && !part.removed) {
      restored.push(...right.slice(from, from + part.count));
      [from, to] = [from + part.count, to + part.count];
      continue;
    }
    // What was taken away and what came in its place.
    const next = parts[at + 1];
    const pair = next !== undefined && (next.added || next.removed) ? [part, next] : [part];
    at += pair.length - 1;
    const count = (of: 'added' | 'removed') => pair.find((each) => each[of])?.count ?? 0;
    const [removed, added] = [count('removed'), count('added')];
    const text = now.slice(to, to + added).map((line) => (isDamaged(line) ? (known.get(line) ?? line) : line));
    const damaged = removed > 0 && text.some(isDamaged);
    const changed = damaged
      ? mendPart(join(read.slice(from, from + removed)), right.slice(from, from + removed).join('\n'), text.join('\n'))
      : text.join('\n');
    restored.push(...(added > 0 ? changed.split('\n') : []));
    [from, to] = [from + removed, to + added];
  }
  const end = /\r\n|\r|\n/.exec(typed)?.[0] ?? '\n';
  return restored.join(end);
}

/** The same of changed lines, character by character. */
function mendPart(bytes: Uint8Array, right: string, typed: string): string {
  const { text, at } = characters(bytes);
  let place = 0;
  let restored = '';
  for (const part of diffChars(text, typed)) {
    if (part.added) {
      restored += part.value;
      continue;
    }
    const end = place + part.value.length;
    if (!part.removed) {
      restored += right.slice(at[place], at[end]);
    }
    place = end;
  }
  return restored;
}

/** Bytes read as UTF-8, with the byte that each unit of its text begins with; at its end, the number of bytes. */
function characters(bytes: Uint8Array): { text: string; at: number[] } {
  const at: number[] = [];
  let text = '';
  for (let place = 0; place < bytes.length; ) {
    const length = sequence(bytes, place);
    const part = new TextDecoder('utf-8', { ignoreBOM: true }).decode(bytes.subarray(place, place + length));
    at.push(...Array.from(part, () => place), ...(part.length > 1 ? [place] : []));
    text += part;
    place += length;
  }
  at.push(bytes.length);
  return { text, at };
}

/** How many bytes from `place` on are read as one character of UTF-8, be it U+FFFD. */
function sequence(bytes: Uint8Array, place: number): number {
  const lead = bytes[place] ?? 0;
  if (lead < 0xc2 || lead > 0xf4) {
    return 1;
  }
  const wanted = lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
  let [low, high] = [0x80, 0xbf];
  low = lead === 0xe0 ? 0xa0 : lead === 0xf0 ? 0x90 : low;
  high = lead === 0xed ? 0x9f : lead === 0xf4 ? 0x8f : high;
  let length = 1;
  for (; length < wanted; length += 1) {
    const byte = bytes[place + length] ?? 0;
    if (byte < low || byte > high) {
      break;
    }
    [low, high] = [0x80, 0xbf];
  }
  return length;
}

function join(parts: readonly Uint8Array[]): Uint8Array {
  return Uint8Array.from(parts.flatMap((part, at) => (at === 0 ? [...part] : [0x0a, ...part])));
}

function lines(text: string): string[] {
  return text.split(/\r\n|\r|\n/);
}

function linesOf(bytes: Uint8Array): Uint8Array[] {
  const found: Uint8Array[] = [];
  let start = 0;
  for (let at = 0; at < bytes.length; at += 1) {
    if (bytes[at] === 0x0d || bytes[at] === 0x0a) {
      found.push(bytes.subarray(start, at));
      at += bytes[at] === 0x0d && bytes[at + 1] === 0x0a ? 1 : 0;
      start = at + 1;
    }
  }
  found.push(bytes.subarray(start));
  return found;
}

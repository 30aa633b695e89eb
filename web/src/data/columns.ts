// The packed data of a page: one deflated stream of a header and columns of whole numbers. What is read here is written
// by src/view/container.rs and column.rs.

/** A column, read back: one number a row, each in as few bytes as the greatest needs. */
export type Numbers = Uint8Array | Uint16Array | Int32Array | Float64Array;

/** What the header says of a column: name, count, order of differences, sparse, wide, bytes. */
type Form = [string, number, number, 0 | 1, 0 | 1, number];

/** Seven bits a character, as the page holds the stream, made bytes again. */
export function bytesOfText(text: string): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(Math.floor((text.length * 7) / 8));
  let held = 0;
  let bits = 0;
  let at = 0;
  for (let index = 0; index < text.length; index += 1) {
    let code = text.charCodeAt(index);
    if (code > 127) {
      code = code === 0xa1 ? 0 : code === 0xa2 ? 13 : 60;
    }
    held = ((held << 7) | code) & 0x7fff;
    bits += 7;
    if (bits >= 8) {
      bits -= 8;
      bytes[at] = held >> bits;
      at += 1;
    }
  }
  return bytes;
}

/** The stream, inflated by the browser. */
export async function inflate(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> {
  const inflater = new DecompressionStream('deflate-raw');
  const writer = inflater.writable.getWriter();
  // What follows the end of the stream, a rest of bits, is an error to some browsers: the end is cut off here.
  const written = writer.write(bytes).then(() => writer.close());
  written.catch(() => undefined);
  const parts: Uint8Array[] = [];
  let length = 0;
  const reader = inflater.readable.getReader();
  for (;;) {
    const { done, value } = await reader.read();
    if (done) {
      break;
    }
    parts.push(value);
    length += value.length;
  }
  const whole = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

/** Reads zigzag varints that are stored by planes. */
class Planes {
  readonly #bytes: Uint8Array;
  readonly #next: number[] = [];

  constructor(bytes: Uint8Array, start: number, count: number) {
    this.#bytes = bytes;
    let at = start;
    let size = count;
    while (size > 0) {
      this.#next.push(at);
      let longer = 0;
      for (let end = at + size; at < end; at += 1) {
        longer += bytes[at]! >> 7;
      }
      size = longer;
    }
    this.#next.push(at);
  }

  /** Where the planes end. Only before the first number is read. */
  get end(): number {
    return this.#next[this.#next.length - 1]!;
  }

  next(): number {
    const bytes = this.#bytes;
    const next = this.#next;
    let byte = bytes[next[0]!++]!;
    if (byte < 128) {
      return byte & 1 ? -((byte + 1) >> 1) : byte >> 1;
    }
    let value = byte & 127;
    let scale = 128;
    for (let plane = 1; ; plane += 1) {
      byte = bytes[next[plane]!++]!;
      value += (byte & 127) * scale;
      if (byte < 128) {
        break;
      }
      scale *= 128;
    }
    return value % 2 === 1 ? -(value + 1) / 2 : value / 2;
  }
}

/** The same numbers in fewer bytes, where they fit. */
function narrowed(values: Int32Array | Float64Array): Numbers {
  if (values instanceof Float64Array) {
    return values;
  }
  // A negative number has its highest bit set.
  let bits = 0;
  for (let row = 0; row < values.length && (bits & ~0xffff) === 0; row += 1) {
    bits |= values[row]!;
  }
  if ((bits & ~0xffff) !== 0) {
    return values;
  }
  return bits > 0xff ? new Uint16Array(values) : new Uint8Array(values);
}

function read(bytes: Uint8Array, start: number, form: Form): Int32Array | Float64Array {
  const [, count, order, sparse, wide] = form;
  // All are 0.
  if (sparse && form[5] === 4) {
    return new Int32Array(count);
  }
  const values = wide ? new Float64Array(count) : new Int32Array(count);
  if (sparse) {
    const kept = new DataView(bytes.buffer, bytes.byteOffset + start).getUint32(0, true);
    const gaps = new Planes(bytes, start + 4, kept);
    const numbers = new Planes(bytes, gaps.end, kept);
    for (let index = 0, row = -1; index < kept; index += 1) {
      row += gaps.next() + 1;
      values[row] = numbers.next();
    }
  } else {
    const numbers = new Planes(bytes, start, count);
    for (let row = 0; row < count; row += 1) {
      values[row] = numbers.next();
    }
  }
  if (order > 0) {
    let last = 0;
    let step = 0;
    for (let row = 0; row < count; row += 1) {
      step = order === 2 ? step + values[row]! : values[row]!;
      last += step;
      values[row] = last;
    }
  }
  return values;
}

/** Texts one behind the other, found by their lengths. */
export class Texts {
  readonly #bytes: Uint8Array;
  readonly #lengths: Numbers;
  #ends: Int32Array | undefined;
  readonly #decoder = new TextDecoder('utf-8', { ignoreBOM: true });

  constructor(bytes: Uint8Array, lengths: Numbers) {
    this.#bytes = bytes;
    this.#lengths = lengths;
  }

  get count(): number {
    return this.#lengths.length;
  }

  bytes(index: number): Uint8Array {
    if (this.#ends === undefined) {
      this.#ends = new Int32Array(this.#lengths.length);
      let end = 0;
      for (let at = 0; at < this.#lengths.length; at += 1) {
        end += this.#lengths[at]!;
        this.#ends[at] = end;
      }
    }
    const end = this.#ends[index] ?? 0;
    return this.#bytes.subarray(end - (this.#lengths[index] ?? 0), end);
  }

  get(index: number): string {
    return this.#decoder.decode(this.bytes(index));
  }
}

/** The columns of an inflated stream by name, and its header. Each column is read once, when it is taken. */
export class Container<H> {
  readonly header: H;
  readonly #bytes: Uint8Array;
  readonly #columns = new Map<string, { form: Form; start: number }>();
  readonly #texts = new Map<string, Uint8Array>();

  constructor(bytes: Uint8Array) {
    const length = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
    const header = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length))) as {
      columns: Form[];
      texts: [string, number][];
    };
    this.#bytes = bytes;
    let start = 4 + length;
    for (const form of header.columns) {
      this.#columns.set(form[0], { form, start });
      start += form[5];
    }
    for (const [name, count] of header.texts) {
      // A copy: the rest can be forgotten.
      this.#texts.set(name, bytes.slice(start, start + count));
      start += count;
    }
    this.header = header as H;
  }

  /** A column; an empty one when the stream has none of that name. */
  take(name: string): Numbers {
    const column = this.#columns.get(name);
    return column === undefined ? new Uint8Array(0) : narrowed(read(this.#bytes, column.start, column.form));
  }

  /** The bytes of a text. */
  text(name: string): Uint8Array {
    return this.#texts.get(name) ?? new Uint8Array(0);
  }

  has(name: string): boolean {
    return this.#columns.has(name);
  }
}

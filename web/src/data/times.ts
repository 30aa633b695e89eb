// Velocities, joints and times of executed blocks, as the motion stream has them. What is read here is written by
// src/view/times.rs, which foretells the same way.

import type { Container, Numbers } from './columns.ts';
import type { Fields, Header, TimeCode } from './header.ts';
import type { Program } from './program.ts';
import { angle } from './tangents.ts';

/** Feeds are whole parts of a mm/min. */
const PER_FEED = 10_000;
/** Angles are whole parts of a degree. */
const PER_DEGREE = 200;

/** Bits of what a record has. */
const MOTION = 1;
const PROGRAMMED = 1 << 1;
const CAP = 1 << 2;
const VELOCITIES = 1 << 3;
const JOINT = 1 << 4;
const ANGLE = 1 << 5;
const WITH = 1 << 6;
const PIECE = 1 << 7;
const UNKNOWN = 1 << 8;
const STRETCH = 1 << 9;
const MERGED = 1 << 10;
const RAPID = 1 << 11;

/** The joint between a motion and the one before it: feeds in mm/min. */
export interface Joint {
  feed: number;
  angle_deg?: number;
  broken_by?: string;
  limited_by?: string;
}

/** Feeds of a motion, in mm/min or deg/min. */
export interface Velocities {
  programmed: number;
  cap: number;
  start: number;
  peak: number;
  end: number;
}

/** Feeds by executed block. They take four bytes each, until one is greater than four bytes hold. */
class Feeds {
  #values: Int32Array | Float64Array;

  constructor(count: number) {
    this.#values = new Int32Array(count);
  }

  get(index: number): number {
    return this.#values[index]!;
  }

  set(index: number, feed: number): void {
    this.#values[index] = feed;
    if (this.#values[index] !== feed && this.#values instanceof Int32Array) {
      this.#values = Float64Array.from(this.#values);
      this.#values[index] = feed;
    }
  }
}

const gained = (accel: number, length: number): number => 2 * accel * length * 3600 * PER_FEED * PER_FEED;

/** Six decimals are more than a feed has. */
const shown = (feed: number): number => feed / PER_FEED;

export class Times {
  readonly #program: Program;
  readonly #codes: TimeCode[];
  /** By executed block: index in the codes. */
  readonly #code: Numbers;
  /** Feeds by executed block, in parts of a mm/min. */
  readonly #programmed: Feeds;
  readonly #cap: Feeds;
  readonly #joint: Feeds;
  readonly #peak: Feeds;
  readonly #end: Feeds;
  /** When each block starts, in seconds; one more at the end. */
  readonly #start: Float64Array;
  /** What is no motion, in microseconds; nothing when all is motion. */
  readonly #other: Numbers | undefined;
  /** What angles differ from what is foretold, and how far back the motion before is. */
  readonly #angle = new Map<number, number>();
  readonly #with = new Map<number, number>();
  readonly #piece = new Map<number, number>();
  #dots: Int32Array | undefined;

  constructor(data: Container<Header>, program: Program) {
    this.#program = program;
    this.#codes = data.header.codes;
    this.#code = data.take('time.code');
    const count = this.#code.length;
    const other = data.take('time.other');
    this.#other = other.some((value) => value !== 0) ? other : undefined;
    this.#programmed = new Feeds(count);
    this.#cap = new Feeds(count);
    this.#joint = new Feeds(count);
    this.#peak = new Feeds(count);
    this.#end = new Feeds(count);
    this.#start = new Float64Array(count + 1);
    this.#readRare(data);
    const timed = this.#readCaps(data);
    this.#readJoints(data, timed);
    this.#readTimes(data, timed, other);
  }

  #has(index: number, bit: number): boolean {
    return (this.#codes[this.#code[index]!]!.has & bit) !== 0;
  }

  #readRare(data: Container<Header>): void {
    const angles = data.take('time.angle');
    const withs = data.take('time.with');
    const pieces = data.take('time.piece');
    let [angle, joint, piece] = [0, 0, 0];
    const { header } = this.#program;
    const bits = header.codes.map((code) => code.has);
    for (let index = 0; index < this.#code.length; index += 1) {
      const has = bits[this.#code[index]!]!;
      if (has & PIECE) {
        this.#piece.set(index, pieces[piece]! / 1e6);
        piece += 1;
      }
      if (has & WITH) {
        if (withs[joint] !== 0) {
          this.#with.set(index, withs[joint]!);
        }
        joint += 1;
      }
      if (has & ANGLE) {
        if (angles[angle] !== 0) {
          this.#angle.set(index, angles[angle]! / PER_DEGREE);
        }
        angle += 1;
      }
    }
  }

  /** Programmed feeds and caps; gives the blocks with velocities. */
  #readCaps(data: Container<Header>): Int32Array {
    const feeds = data.take('time.programmed');
    const caps = data.take('time.cap');
    const program = this.#program;
    const fed = program.header.states.map((state) => {
      const unit = state['feed_unit'];
      return unit === 'mm/min' || unit === 'deg/min' ? (state['feed_scale'] === undefined ? 1 : 0.01) : 0;
    });
    const timed = new Int32Array(this.#code.length);
    let count = 0;
    const last = { rapid: 0, other: 0 };
    let [shortest, limit] = [0, 0];
    let [nextFeed, nextCap] = [0, 0];
    for (let index = 0; index < this.#code.length; index += 1) {
      const code = this.#codes[this.#code[index]!]!;
      if (code.has & VELOCITIES) {
        timed[count] = index;
        count += 1;
      }
      if (code.has & PROGRAMMED) {
        const kind = code.has & RAPID ? 'rapid' : 'other';
        let foretold = last[kind];
        if (kind === 'other') {
          const row = program.rowOf(index);
          const scale = fed[program.state[row]!]!;
          const feed = program.feed[row]! * 10;
          foretold = scale === 1 ? feed : scale === 0.01 ? Math.floor(feed / 100 + 0.5) : foretold;
        }
        last[kind] = foretold + feeds[nextFeed]!;
        this.#programmed.set(index, last[kind]);
        nextFeed += 1;
      }
      if (code.has & CAP && code.cap_by !== undefined) {
        const { cap_by: by } = code;
        const free = by === 'feed' || by === 'rapid';
        const length = by === 'shortest_block' ? this.#length(index) : 0;
        const foretold = free
          ? this.#programmed.get(index)
          : by === 'shortest_block'
            ? Math.round(shortest * length)
            : limit;
        const cap = foretold + caps[nextCap]!;
        nextCap += 1;
        this.#cap.set(index, cap);
        if (by === 'shortest_block') {
          if (shortest === 0 && length > 0) {
            shortest = cap / length;
          }
        } else if (!free) {
          limit = cap;
        }
      }
    }
    return timed.slice(0, count);
  }

  /** In millimetres or degrees, of the piece when blocks are joined. */
  #length(index: number): number {
    return this.#piece.get(index) ?? this.#program.lengthOf(this.#program.rowOf(index));
  }

  #accel(code: TimeCode): number {
    return this.#program.header.accels[code.a ?? 0] ?? 0;
  }

  #codeOf(index: number): TimeCode {
    return this.#codes[this.#code[index]!]!;
  }

  #readJoints(data: Container<Header>, timed: Int32Array): void {
    const corrections = data.take('time.joint');
    const joint = this.#joint;
    const cap = this.#cap;
    const codes = this.#codes;
    const passed = codes.map((code) => (code.has & JOINT) !== 0 && code.broken_by === undefined);
    const modes = codes.map((code) => code.j ?? 0);
    for (let place = 0; place < timed.length; place += 1) {
      const index = timed[place]!;
      const code = this.#code[index]!;
      if (passed[code] && modes[code] === 0) {
        joint.set(index, Math.min(place === 0 ? 0 : cap.get(timed[place - 1]!), cap.get(index)) + corrections[place]!);
      }
    }
    for (let place = 1; place < timed.length; place += 1) {
      const index = timed[place]!;
      if (modes[this.#code[index]!] === 1) {
        const before = timed[place - 1]!;
        const from = joint.get(before);
        joint.set(
          index,
          Math.round(Math.sqrt(from * from + gained(this.#accel(this.#codeOf(before)), this.#length(before)))),
        );
      }
    }
    for (let place = timed.length - 1; place >= 0; place -= 1) {
      const index = timed[place]!;
      if (modes[this.#code[index]!] === 2) {
        const next = timed[place + 1];
        const to = this.#passedAt(next, passed);
        const fallen = Math.sqrt(to * to + gained(this.#accel(this.#codeOf(index)), this.#length(index)));
        joint.set(index, Math.round(fallen) + corrections[place]!);
      }
    }
    for (let place = 0; place < timed.length; place += 1) {
      this.#end.set(timed[place]!, this.#passedAt(timed[place + 1], passed));
    }
  }

  /** The velocity at the joint before the next motion, which may lie beyond the page. */
  #passedAt(next: number | undefined, passed: boolean[]): number {
    if (next === undefined) {
      return this.#program.header.beyond.feed;
    }
    return passed[this.#code[next]!] ? this.#joint.get(next) : 0;
  }

  #readTimes(data: Container<Header>, timed: Int32Array, other: Numbers): void {
    const peaks = data.take('time.peak');
    const durations = data.take('time.duration');
    let place = 0;
    let clock = 0;
    for (let index = 0; index < this.#code.length; index += 1) {
      let motion = 0;
      if (timed[place] === index) {
        const code = this.#codeOf(index);
        const [start, end] = [this.#joint.get(index), this.#end.get(index)];
        const most = Math.max(start, end);
        const accel = this.#accel(code);
        const length = this.#length(index);
        let peak = most;
        if ((code.k ?? 0) === 0) {
          const reached = Math.sqrt((start * start + end * end) / 2 + gained(accel, length) / 2);
          peak = Math.max(Math.min(this.#cap.get(index), Math.round(reached)), most);
        }
        peak += peaks[place]!;
        this.#peak.set(index, peak);
        motion = duration(start, end, peak, accel, length);
        place += 1;
      }
      clock += Math.round(motion * 1e6) + (other[index] ?? 0) + durations[index]!;
      this.#start[index + 1] = clock / 1e6;
    }
  }

  /** When a block starts, in seconds from the first of the page. */
  startOf(index: number): number {
    return this.#start[index]!;
  }

  durationOf(index: number): number {
    return this.#start[index + 1]! - this.#start[index]!;
  }

  /** Whether the time of a block is not known: it takes at least its duration. */
  isUnknown(index: number): boolean {
    return this.#has(index, UNKNOWN);
  }

  /** Of all blocks in the page, in seconds. */
  get total(): number {
    return this.#start[this.#start.length - 1]!;
  }

  /** The block at a time: of those that take none, the one before. */
  at(seconds: number): number {
    let low = 0;
    let high = this.#code.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.#start[middle + 1]! <= seconds) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return Math.min(low, Math.max(this.#code.length - 1, 0));
  }

  velocities(index: number): Velocities | undefined {
    if (!this.#has(index, VELOCITIES)) {
      return undefined;
    }
    return {
      programmed: shown(this.#programmed.get(index)),
      cap: shown(this.#cap.get(index)),
      start: shown(this.#joint.get(index)),
      peak: shown(this.#peak.get(index)),
      end: shown(this.#end.get(index)),
    };
  }

  /** The greatest feed of a block, 0 when it is not known. */
  peakOf(index: number): number {
    return shown(this.#peak.get(index));
  }

  /** How the velocity of a block runs: shares of its time, with feeds. */
  shape(index: number): [number, number][] {
    const known = this.velocities(index);
    const total = this.durationOf(index);
    if (known === undefined || total <= 0) {
      return [];
    }
    const accel = this.#accel(this.#codeOf(index)) * 60;
    const share = (from: number, to: number): number => (accel > 0 ? (to - from) / accel / total : 0.25);
    const rise = Math.min(share(known.start, known.peak), 1);
    const fall = Math.min(share(known.end, known.peak), 1 - rise);
    const rest = Math.min((this.#other?.[index] ?? 0) / 1e6 / total, Math.max(1 - rise - fall, 0));
    const points: [number, number][] = [
      [0, known.start],
      [rise, known.peak],
      [1 - fall - rest, known.peak],
      [1 - rest, known.end],
    ];
    return rest > 0 ? [...points, [1 - rest, 0], [1, 0]] : points;
  }

  /** How much of a block's way is done at a share of its time. */
  wayAt(index: number, share: number): number {
    const points = this.shape(index);
    let [way, done] = [0, 0];
    for (let i = 1; i < points.length; i += 1) {
      const [[from, slow], [to, fast]] = [points[i - 1]!, points[i]!];
      const whole = ((slow + fast) / 2) * (to - from);
      way += whole;
      if (share >= to) {
        done += whole;
      } else if (share > from) {
        const part = (share - from) / (to - from || 1);
        done += ((slow + slow + (fast - slow) * part) / 2) * (share - from);
      }
    }
    return way > 0 ? Math.min(done / way, 1) : share;
  }

  /** Shares of a block's way: how much of it the velocity rises, and how much it falls; nothing without velocities. */
  ramps(index: number): { start: number; peak: number; end: number; rise: number; fall: number } | undefined {
    const known = this.velocities(index);
    if (known === undefined) {
      return undefined;
    }
    const { start, peak, end } = known;
    const gain = 2 * this.#accel(this.#codeOf(index)) * 3600 * this.#length(index);
    const share = (from: number): number => (peak <= from ? 0 : gain > 0 ? (peak * peak - from * from) / gain : 0.25);
    const [rise, fall] = [share(start), share(end)];
    const most = Math.max(rise + fall, 1);
    return { start, peak, end, rise: rise / most, fall: fall / most };
  }

  /** The greatest velocity at which the joint before a block may be passed (VEL-7); nothing without a joint. */
  jointCap(index: number): number | undefined {
    const joint = this.joint(index);
    if (joint === undefined || joint.broken_by !== undefined) {
      return joint?.feed;
    }
    if (joint.limited_by !== 'ramp' && joint.limited_by !== 'look_ahead') {
      return joint.feed;
    }
    const before = this.#before(index) ?? -1;
    const caps = [this.#cap.get(index) / PER_FEED];
    for (const block of before < 0 ? [index] : [before, index]) {
      caps.push(this.#cap.get(block) / PER_FEED, this.#cornerCap(block, joint.angle_deg ?? 0));
    }
    // A value that a parameter of the machine gives is not known here.
    return Math.max(Math.min(...caps), joint.feed);
  }

  /** What accuracy and overload let pass at a corner (VEL-4, VEL-5), by the values that hold in a block. */
  #cornerCap(index: number, angle: number): number {
    const machine = this.#program.header.machine;
    const cycle = machine?.['cycle_ms'];
    if (machine === undefined || machine['profile'] === 'ramps' || typeof cycle !== 'number' || angle === 0) {
      return Infinity;
    }
    const program = this.#program;
    const set = program.header.states[program.state[program.rowOf(index)]!]!['dynamic_set'] ?? 1;
    const own = ((machine['sets'] ?? {}) as Fields)[String(set)] as Fields | undefined;
    const value = (name: string): number => {
      const found = own?.[name] ?? machine[name];
      return typeof found === 'number' && found > 0 ? found : Infinity;
    };
    const half = (angle * Math.PI) / 360;
    const accuracy = value('accuracy_um') / (cycle * Math.tan(half));
    const overload = (value('overload_mm_s2') * cycle) / 1000 / (2 * Math.sin(half));
    return Math.min(accuracy, overload) * 60;
  }

  dotOf(index: number): 'red' | 'yellow' | undefined {
    return this.#codeOf(index).dot;
  }

  /** The motion block before the joint of a block, as an index; it may lie before the page. */
  #before(index: number): number | undefined {
    if (!this.#has(index, WITH)) {
      return undefined;
    }
    let last = index - 1;
    while (last >= 0 && (this.#codeOf(last).has & (MOTION | MERGED)) !== MOTION) {
      last -= 1;
    }
    return index - ((last < 0 ? 0 : index - last) + (this.#with.get(index) ?? 0));
  }

  joint(index: number): Joint | undefined {
    const code = this.#codeOf(index);
    if ((code.has & JOINT) === 0) {
      return undefined;
    }
    const joint: Joint = { feed: shown(this.#joint.get(index)) };
    if (code.has & ANGLE) {
      const before = this.#before(index)!;
      const program = this.#program;
      const foretold = before < 0 ? 0 : angle(program, program.rowOf(before), program.rowOf(index));
      joint.angle_deg = Math.round((foretold + (this.#angle.get(index) ?? 0)) * 1e6) / 1e6;
    }
    if (code.broken_by !== undefined) {
      joint.broken_by = code.broken_by;
    }
    const limit = code.limited_by ?? code.broken_by;
    if (limit !== undefined) {
      joint.limited_by = limit;
    }
    return joint;
  }

  /** The blocks whose joint has a dot, ascending. */
  dots(): Int32Array {
    if (this.#dots === undefined) {
      const has = this.#codes.map((code) => code.dot !== undefined);
      const code = this.#code;
      let count = 0;
      for (let index = 0; index < code.length; index += 1) {
        count += has[code[index]!] ? 1 : 0;
      }
      this.#dots = new Int32Array(count);
      for (let index = 0, at = 0; index < code.length; index += 1) {
        if (has[code[index]!]) {
          this.#dots[at] = index;
          at += 1;
        }
      }
    }
    return this.#dots;
  }

  /** Those of them whose dot is red. */
  redDots(): Int32Array {
    const red = this.#codes.map((code) => code.dot === 'red');
    return this.dots().filter((index) => red[this.#code[index]!]!);
  }

  /** Seconds of motion from the start of a block to the end of its stretch. */
  #rest(index: number): number {
    let end = index + 1;
    while (end < this.#code.length && this.#codeOf(end).broken_by === undefined && this.#has(end, MOTION)) {
      end += 1;
    }
    const beyond = end === this.#code.length ? this.#program.header.beyond.rest_s : 0;
    let rest = this.#start[end]! - this.#start[index]! + beyond;
    if (this.#other !== undefined) {
      for (let block = index; block < end; block += 1) {
        rest -= this.#other[block]! / 1e6;
      }
    }
    return rest;
  }

  /** The record of a block in the motion stream, without what the block record has. */
  record(index: number): Fields {
    const { has, cap_by, dot } = this.#codeOf(index);
    const record: Fields = {
      start_s: this.#program.header.start_s + this.#start[index]!,
      duration_s: this.durationOf(index),
    };
    if (has & MERGED) {
      record['merged'] = true;
    }
    if (has & PROGRAMMED) {
      record['programmed'] = shown(this.#programmed.get(index));
    }
    if (has & CAP) {
      record['cap'] = shown(this.#cap.get(index));
      record['cap_by'] = cap_by!;
    }
    if (has & VELOCITIES) {
      record['start'] = shown(this.#joint.get(index));
      record['peak'] = shown(this.#peak.get(index));
      record['end'] = shown(this.#end.get(index));
    }
    if (has & PIECE) {
      record['piece_mm'] = this.#piece.get(index)!;
    }
    if (has & STRETCH) {
      record['time_dist_s'] = this.#rest(index);
    }
    const joint = this.joint(index);
    if (joint !== undefined) {
      const before = this.#before(index);
      const fields: Fields = { ...(joint as object) };
      if (before !== undefined) {
        fields['with'] = this.#program.from + before;
      }
      if (joint.broken_by === undefined) {
        fields['continuous'] = true;
      }
      if (dot !== undefined) {
        fields['dot'] = dot;
      }
      record['joint'] = fields;
    }
    return record;
  }
}

/** Seconds of a motion that rises to its greatest velocity and falls, by one acceleration. */
function duration(startFeed: number, endFeed: number, peakFeed: number, accel: number, length: number): number {
  const start = startFeed / PER_FEED / 60;
  const end = endFeed / PER_FEED / 60;
  const peak = peakFeed / PER_FEED / 60;
  if (peak <= 0) {
    return 0;
  }
  if (accel <= 0) {
    return length / peak;
  }
  const ramps = (peak * peak - start * start + peak * peak - end * end) / (2 * accel);
  return (peak - start) / accel + (peak - end) / accel + Math.max(length - ramps, 0) / peak;
}

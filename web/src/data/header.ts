// What the header of a page's data holds. src/view writes it.

/** A value as JSON has it. */
export type Json = null | boolean | number | string | Json[] | { [key: string]: Json };

/** Fields of a record by name. */
export interface Fields {
  [key: string]: Json;
}

/** What rows have in common about their motion and positions. */
export interface Shape {
  /** Letters of the axes whose position is known after the block. */
  k?: string;
  /** Letters of those whose value is in the column of positions; the others stand where they stood. */
  c?: string;
  /** Why axes are not known behind the block, by letter; those that are not known without a reason are not programmed yet. */
  w?: { [letter: string]: string };
  /** The motion, without numbers. */
  m?: Fields;
  /** Letters of the axes whose start is known. */
  s?: string;
  /** What the length is measured in, when it is known. */
  l?: 'mm' | 'deg';
  /** Letters of the axes that make the length. */
  a?: string;
  /** The axes of an arc whose centre is known, first-named first. */
  r?: string;
  /** The block moves where nobody knows: a fixed cycle that is not mapped, a macrocycle of the machine. */
  u?: true;
  /** The motion starts where the tool does not stand, behind a change of origin. */
  o?: true;
}

/** What a finding says, in both languages. */
export interface PageFinding {
  code: string;
  name: string;
  severity: 'error' | 'warning' | 'note';
  message: { en: string; cs: string };
  /** Index of the file; absent when it is no file of the page. */
  file?: number;
  line?: number;
  column?: number;
  path?: string;
}

/** What motions have in common about their times, by code. */
export interface TimeCode {
  /** What the record has, in bits: see times.ts. */
  has: number;
  cap_by?: string;
  broken_by?: string;
  limited_by?: string;
  dot?: 'red' | 'yellow';
  /** Index of the acceleration. */
  a?: number;
  /** What the velocity at the joint is foretold from: both caps, the joint before (1), the joint behind (2). */
  j?: number;
  /** What the greatest velocity is foretold from: cap and acceleration, the velocities at both ends (1). */
  k?: number;
}

/** How far motions go, in millimetres; `lacks`: the axes that go farther than is known. */
export interface Size {
  axes: { [letter: string]: [number, number] };
  lacks: string;
}

/** One piece of the equidistant path. */
export interface EquidistantPiece {
  seq: number;
  /** Points, three coordinates each, in mm. */
  points: number[];
  /** The element collides. */
  bad?: boolean;
}

/** What another program does differently: the record of `cnc872c compare --format json`, with texts. */
export interface Compared {
  same: boolean;
  old: Fields;
  new: Fields;
  changes: Fields[];
  /** What both take; then a text for each change. */
  head: { en: string[]; cs: string[] };
  texts: { en: string[]; cs: string[] };
  /** Changes that are not listed: how many, and their blocks. */
  rest?: Fields;
}

export interface Header {
  schema: string;
  generator: string;
  /** The record of the program, as the block stream has it. */
  program: Fields & { name: string; axes: { letter: string; kind: string }[]; number: number; title?: string };
  /** The parameters that the machine has at the program's start. */
  given?: { [name: string]: number };
  /** The arguments with which a command executes the program as the page shows it. */
  arguments?: string[];
  /** The records `machine` and `total` of the motion stream. */
  machine?: Fields;
  total?: Fields;
  /**
   * Files in the order of their indices: name, number of blocks, of their comments, the text before the first of them, how
   * many of the comments are in it.
   */
  files: { name: string; blocks: number; comments: number; head: string; head_comments: number }[];
  /** Blocks of the whole program that were executed. */
  blocks: number;
  /** The first seq in the page, and how many follow. */
  from: number;
  count: number;
  /** The program ended with M02 or M30; else with an error. */
  whole: boolean;
  /** What is in force. No field of records: the G functions that hold behind the block, where `g` does not say it. */
  states: (Fields & { held?: (number | null)[] })[];
  /** What blocks do. No field of records: what they write besides the positions of the axes that they move, as `state` says. */
  extras: (Fields & { written?: string[] })[];
  shapes: Shape[];
  calls: { by: string; l: number }[];
  codes: TimeCode[];
  /** Accelerations of motions, in mm/s². */
  accels: number[];
  /** When the first block of the page starts, in seconds. */
  start_s: number;
  /** The rest of the stretch in which the page ends: the velocity at its first joint, in parts of a mm/min; seconds. */
  beyond: { feed: number; rest_s: number };
  /** The known path from the program's start to every so many blocks of the page, and to the program's end. */
  ways: { apart: number; mm: number[] };
  /** By letter: what the numbers in the text are foretold from. */
  foretold: { [letter: string]: 'row' };
  /** Parts of a millimetre or degree that numbers count, by column. */
  per: { [column: string]: number };
  /** How far working motions go, and all. */
  size: { working: Size; all: Size };
  findings: PageFinding[];
  /** A lathe: seen in ZX at first. */
  turning: boolean;
  /** X is programmed as a diameter; positions are radii. */
  diameter: boolean;
  equidistant?: { pieces: EquidistantPiece[] };
  /** Of a page of `compare`. */
  compared?: Compared;
}

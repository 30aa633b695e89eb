// What draws the path: on a graphics processor, or without one.

import type { Vector } from './camera.ts';
import type { Lines } from './lines.ts';

/** A dot: where, and which. */
export interface Dots {
  /** Three numbers a dot, in mm. */
  points: Float32Array;
  /** By dot: 1 red, 0 yellow. */
  red: Uint8Array;
}

/** Plain lines under the path, such as the grid: pairs of points in mm, with their colour. */
export interface Underlay {
  points: Vector[];
  colours: number[];
}

/** What one picture is made of. Colours are 0xAABBGGRR. */
export interface Frame {
  background: number;
  matrix: Float64Array;
  underlay: Underlay;
  lines: Lines;
  /** Lines under them, those of the old program; over them, those of the change that is shown. */
  under: Lines[];
  over: Lines[];
  /** The chord behind the last one that is drawn in full colour; those behind it are faint. */
  until: number;
  /** Every so many chords are drawn as one. */
  step: number;
  /** Width of lines, in CSS pixels. */
  width: number;
  dots: Dots;
  dotColours: { red: number; yellow: number; edge: number };
}

export interface Renderer {
  /** `gl` on a graphics processor, `software` without one. */
  readonly name: 'gl' | 'software';
  /** Gives the canvas a size in CSS pixels. */
  resize(width: number, height: number, ratio: number): void;
  draw(frame: Frame): void;
  /** The lines have changed: points or colours. */
  changed(what: 'points' | 'colours'): void;
}

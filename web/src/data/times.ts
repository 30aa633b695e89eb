// Velocities, joints and times of executed blocks, as the motion stream has them.

import type { Container } from './columns.ts';
import type { Fields, Header } from './header.ts';
import type { Program } from './program.ts';

/** A joint with a dot. */
export interface Dot {
  index: number;
  red: boolean;
}

export interface Joint {
  feed: number;
  angle_deg?: number;
  broken_by?: string;
  limited_by?: string;
}

export class Times {
  constructor(_data: Container<Header>, _program: Program) {
    throw new Error('not yet');
  }
  startOf(_index: number): number {
    return 0;
  }
  durationOf(_index: number): number {
    return 0;
  }
  peakOf(_index: number): number {
    return 0;
  }
  shape(_index: number): [number, number][] {
    return [];
  }
  dotOf(_index: number): 'red' | 'yellow' | undefined {
    return undefined;
  }
  joint(_index: number): Joint | undefined {
    return undefined;
  }
  get total(): number {
    return 0;
  }
  at(_seconds: number): number {
    return 0;
  }
  velocities(_index: number): { programmed: number; cap: number; start: number; peak: number; end: number } | undefined {
    return undefined;
  }
  record(_index: number): Fields {
    return {};
  }
  dots(): Dot[] {
    return [];
  }
}

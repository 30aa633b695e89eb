// Colours of the path and of the page. All are told apart by the colour-blind: hues of Okabe and Ito for kinds, a scale
// whose lightness rises for values.

import type { App, ColourBy } from '../app.ts';
import { mixed } from './raster.ts';
import type { Lines } from './lines.ts';

/** A colour from its parts, as pixels hold it: 0xAABBGGRR. */
export function colour(hex: string): number {
  const value = Number.parseInt(hex.slice(1), 16);
  return (0xff000000 | ((value & 255) << 16) | (value & 0xff00) | (value >> 16)) >>> 0;
}

/** The same as CSS writes it. */
export function css(value: number): string {
  const part = (shift: number): string => ((value >>> shift) & 255).toString(16).padStart(2, '0');
  return `#${part(0)}${part(8)}${part(16)}`;
}

export interface Theme {
  dark: boolean;
  background: number;
  ink: string;
  faint: string;
  gridLine: number;
  gridStrong: number;
  kinds: number[];
  /** The velocity in the chart. */
  velocity: number;
  axes: [string, string, string];
  selection: string;
  selectionEdge: string;
  red: number;
  yellow: number;
  dotEdge: number;
  equidistant: number;
  collision: number;
}

export const LIGHT: Theme = {
  dark: false,
  background: colour('#fbfcfd'),
  ink: '#1d2b36',
  faint: '#5b6b78',
  gridLine: colour('#e6ebef'),
  gridStrong: colour('#cfd8de'),
  // None is blue: that is the equidistant's.
  kinds: ['#8a97a3', '#33414d', '#00805f', '#8a3f86'].map(colour),
  velocity: colour('#0b62a8'),
  axes: ['#b3261e', '#1c7a2e', '#1f4fbf'],
  selection: '#e0218a',
  selectionEdge: '#ffffff',
  red: colour('#d81f26'),
  yellow: colour('#f2b705'),
  dotEdge: colour('#26323b'),
  equidistant: colour('#2f6fed'),
  collision: colour('#d81f26'),
};

export const DARK: Theme = {
  dark: true,
  background: colour('#12181d'),
  ink: '#e4ebf0',
  faint: '#9aa9b4',
  gridLine: colour('#1f2930'),
  gridStrong: colour('#2f3c45'),
  kinds: ['#73828e', '#d3dde4', '#2fc79a', '#d58ad0'].map(colour),
  velocity: colour('#56b4e9'),
  axes: ['#ff7b72', '#56d364', '#79b0ff'],
  selection: '#ff5fb3',
  selectionEdge: '#12181d',
  red: colour('#ff4d4f'),
  yellow: colour('#ffd43b'),
  dotEdge: colour('#0a0f12'),
  equidistant: colour('#6ea0ff'),
  collision: colour('#ff4d4f'),
};

const HUES = ['#0072b2', '#e69f00', '#009e73', '#cc79a7', '#56b4e9', '#d55e00', '#7a68c9', '#8a8f23'].map(colour);

/** From slow to fast, early to late: darker to lighter on dark ground, the other way on light. */
const SCALE = {
  dark: ['#4b2f91', '#3f62b5', '#2f93a8', '#4bbd7c', '#b5d94c', '#fde047'].map(colour),
  light: ['#d9a400', '#8fae1b', '#2f9d6b', '#1f7f96', '#335fa8', '#46217f'].map(colour),
};

/** A colour of the scale, for a share from 0 to 1. */
export function scaled(share: number, theme: Theme): number {
  const scale = theme.dark ? SCALE.dark : SCALE.light;
  const place = Math.min(Math.max(share, 0), 1) * (scale.length - 1);
  const low = Math.min(Math.floor(place), scale.length - 2);
  return mixed(scale[low]!, scale[low + 1]!, place - low);
}

/** What colours mean: kinds with their colours, or a scale from … to …. */
export type Legend =
  | { kind: 'names'; items: { name: string; colour: number; dashed?: boolean }[] }
  | { kind: 'scale'; from: number; to: number; unit: string };

/** Gives every chord its colour, and says what the colours mean. Names are left to the caller as keys. */
export function paint(app: App, lines: Lines, theme: Theme, by: ColourBy): Legend {
  const { colours, rows, kinds, count } = lines;
  const { program, times } = app;
  const each = (of: (row: number) => number): void => {
    let row = -1;
    let found = 0;
    for (let chord = 0; chord < count; chord += 1) {
      if (rows[chord] !== row) {
        row = rows[chord]!;
        found = of(row);
      }
      colours[2 * chord] = found;
      colours[2 * chord + 1] = found;
    }
  };
  const byName = (of: (row: number) => number | null, name: (value: number | null) => string): Legend => {
    const known = new Map<number | null, number>();
    each((row) => {
      const value = of(row);
      let hue = known.get(value);
      if (hue === undefined) {
        hue = value === null ? theme.kinds[0]! : HUES[known.size % HUES.length]!;
        known.set(value, hue);
      }
      return hue;
    });
    const items = [...known].sort(([a], [b]) => (a ?? -1) - (b ?? -1));
    return { kind: 'names', items: items.map(([value, hue]) => ({ name: name(value), colour: hue })) };
  };
  const state = (row: number, field: string): number | null => {
    const value = program.header.states[program.state[row]!]![field];
    return typeof value === 'number' ? value : null;
  };
  switch (by) {
    case 'motion': {
      const seen = new Set<number>();
      for (let chord = 0; chord < count; chord += 1) {
        const kind = kinds[chord]!;
        colours[2 * chord] = theme.kinds[kind]!;
        colours[2 * chord + 1] = theme.kinds[kind]!;
        if (chord === 0 || kind !== kinds[chord - 1]) {
          seen.add(kind);
        }
      }
      const names = ['rapid', 'linear', 'arc', 'thread'];
      const items = [...seen].sort().map((kind) => ({
        name: names[kind]!,
        colour: theme.kinds[kind]!,
        dashed: kind === 0,
      }));
      return { kind: 'names', items };
    }
    case 'tool':
      return byName((row) => state(row, 'tool'), (tool) => (tool === null ? '' : `T${tool}`));
    case 'set':
      return byName((row) => state(row, 'dynamic_set') ?? 1, (set) => String(set));
    case 'feed': {
      let [low, high] = [Infinity, -Infinity];
      const isRapid = (row: number): boolean => lines.path.kind(row) === 0;
      for (let chord = 0; chord < count; chord += 1) {
        if (kinds[chord] !== 0 && program.feed[rows[chord]!]! > 0) {
          low = Math.min(low, program.feed[rows[chord]!]!);
          high = Math.max(high, program.feed[rows[chord]!]!);
        }
      }
      const span = high > low ? high - low : 1;
      each((row) =>
        isRapid(row) || program.feed[row]! === 0 ? theme.kinds[0]! : scaled((program.feed[row]! - low) / span, theme),
      );
      return { kind: 'scale', from: low / 1000, to: high / 1000, unit: 'F' };
    }
    case 'time': {
      const total = times?.total ?? program.count;
      each((row) => {
        const index = program.firstIndexOf(row);
        return scaled((times?.startOf(index) ?? index) / (total || 1), theme);
      });
      return { kind: 'scale', from: 0, to: total, unit: times === undefined ? 'N' : 's' };
    }
    case 'velocity': {
      if (times === undefined) {
        each(() => theme.kinds[0]!);
        return { kind: 'names', items: [] };
      }
      let high = 0;
      for (let chord = 0; chord < count; chord += 1) {
        if (kinds[chord] !== 0) {
          high = Math.max(high, times.peakOf(program.firstIndexOf(rows[chord]!)));
        }
      }
      let last = -1;
      let part = 0;
      for (let chord = 0; chord < count; chord += 1) {
        const row = rows[chord]!;
        const index = program.firstIndexOf(row);
        part = row === last ? part + 1 : 0;
        if (row !== last || part > 0) {
          last = row;
        }
        const known = times.velocities(index);
        if (known === undefined) {
          colours[2 * chord] = theme.kinds[0]!;
          colours[2 * chord + 1] = theme.kinds[0]!;
          continue;
        }
        const alone = rows[chord + 1] !== row && part === 0;
        if (alone) {
          colours[2 * chord] = scaled(known.start / (high || 1), theme);
          colours[2 * chord + 1] = scaled(known.end / (high || 1), theme);
        } else {
          // A line of several chords shows how the velocity rises to its peak and falls.
          let parts = part + 1;
          while (rows[chord + parts - part] === row) {
            parts += 1;
          }
          const at = (share: number): number =>
            share < 0.5
              ? known.start + (known.peak - known.start) * Math.min(share * 4, 1)
              : known.end + (known.peak - known.end) * Math.min((1 - share) * 4, 1);
          colours[2 * chord] = scaled(at(part / parts) / (high || 1), theme);
          colours[2 * chord + 1] = scaled(at((part + 1) / parts) / (high || 1), theme);
        }
      }
      return { kind: 'scale', from: 0, to: high, unit: 'mm/min' };
    }
  }
}

// Colours of the path and of the page. All are told apart by the colour-blind: hues of Okabe and Ito for kinds, a scale
// whose lightness rises for values.

import type { App, ColourBy } from '../app.ts';
import { type Comparison, Fate, type Side } from '../data/compared.ts';
import { type Cuts, Dash, type Lines } from './lines.ts';
import { mixed } from './raster.ts';

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
  /** Of compared programs: lines of the old one that the new one lacks; lines that run as before under other values. */
  old: number;
  values: number;
  asBefore: number;
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
  asBefore: colour('#b3bec7'),
  old: colour('#d55e00'),
  values: colour('#8a3f86'),
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
  asBefore: colour('#55626d'),
  old: colour('#ff9b4a'),
  values: colour('#d58ad0'),
};

const HUES = ['#0072b2', '#e69f00', '#009e73', '#cc79a7', '#56b4e9', '#d55e00', '#7a68c9', '#8a8f23'].map(colour);

/** The look of the next of many names: eight hues, then the same in other dashes and shades. */
function look(place: number, theme: Theme): { colour: number; dash: Dash } {
  const round = Math.floor(place / HUES.length) % 6;
  const hue = HUES[place % HUES.length]!;
  const shade = round % 2 === 0 ? hue : mixed(hue, colour(theme.dark ? '#ffffff' : '#000000'), 0.5);
  const dash = ([Dash.Solid, Dash.Long, Dash.Short] as const)[Math.floor((round + 1) / 2) % 3]!;
  return { colour: shade, dash };
}

/**
 * From slow to fast, early to late: darker to lighter on dark ground, the other way on light. One for each unit of what is
 * shown; the sheet of styles has the same.
 */
const SCALES = [
  {
    dark: ['#4b2f91', '#3f62b5', '#2f93a8', '#4bbd7c', '#b5d94c', '#fde047'].map(colour),
    light: ['#d9a400', '#8fae1b', '#2f9d6b', '#1f7f96', '#335fa8', '#46217f'].map(colour),
  },
  {
    dark: ['#7a2230', '#a83a3f', '#d2604a', '#ee9064', '#fbc499', '#ffeedd'].map(colour),
    light: ['#f0906a', '#dd6a4d', '#bd4740', '#962c3c', '#6d1a35', '#450d28'].map(colour),
  },
];

/** A colour of a scale, for a share from 0 to 1. */
export function scaled(share: number, theme: Theme, which = 0): number {
  const { dark, light } = SCALES[which % SCALES.length]!;
  const scale = theme.dark ? dark : light;
  const place = Math.min(Math.max(share, 0), 1) * (scale.length - 1);
  const low = Math.min(Math.floor(place), scale.length - 2);
  return mixed(scale[low]!, scale[low + 1]!, place - low);
}

/** Gives the lines of one of two compared programs the colours of what became of them; the old one's are dashed. */
export function paintHalf(comparison: Comparison, side: Side, lines: Lines, theme: Theme): void {
  const { fates } = comparison[side];
  const looks = [theme.asBefore, theme.values, side === 'old' ? theme.old : theme.kinds[2]!];
  lines.dashes = side === 'old' ? new Uint8Array(lines.count) : undefined;
  lines.rows.forEach((row, chord) => {
    const fate = fates[row]!;
    lines.colours.fill(looks[fate]!, 2 * chord, 2 * chord + 2);
    if (lines.dashes !== undefined && fate === Fate.Moved) {
      lines.dashes[chord] = Dash.Long;
    }
  });
}

/** What colours mean: kinds with their colours, or scales from … to …, one for each unit. */
export type Legend =
  | { kind: 'names'; items: { name: string; colour: number; dash: Dash }[] }
  | { kind: 'scale'; scales: { from: number; to: number; unit: string }[] };

/** So many pieces are added to the picture by cutting lines, at most. */
const MOST_CUTS = 200_000;
/** Shares of a ramp, with those of the change of velocity: it rises as the root of the way. */
const ON_RAMP = [0.06, 0.3];

/** The greatest velocity of working motion. */
function fastest(app: App): number {
  const { path, program, times } = app;
  let high = 0;
  for (const row of path.rows) {
    if (path.kind(row) !== 0) {
      high = Math.max(high, times!.peakOf(program.firstIndexOf(row)));
    }
  }
  return high;
}

/**
 * Where straight lines are cut so that colours by velocity show how it rises and falls; nothing without times. Where too many
 * would be, only those whose velocity changes much.
 */
export function rampCuts(app: App): Cuts | undefined {
  const { path, program, times } = app;
  if (times === undefined) {
    return undefined;
  }
  const high = fastest(app);
  for (let visible = 0.02; ; visible *= 2) {
    const cuts = new Map<number, number[]>();
    let count = 0;
    for (const row of path.rows) {
      const ramps = path.isArc(row) ? undefined : times.ramps(program.firstIndexOf(row));
      if (ramps === undefined) {
        continue;
      }
      const { start, peak, end, rise, fall } = ramps;
      const found: number[] = [];
      if (peak - start > visible * high) {
        found.push(...ON_RAMP.map((share) => share * rise), rise);
      }
      if (peak - end > visible * high) {
        found.push(1 - fall, ...ON_RAMP.map((share) => 1 - share * fall).reverse());
      }
      const within = found.filter((share, i) => share > 1e-6 && share < 1 - 1e-6 && share > (found[i - 1] ?? 0) + 1e-6);
      if (within.length > 0) {
        cuts.set(row, within);
        count += within.length;
      }
      if (count > MOST_CUTS) {
        break;
      }
    }
    if (count <= MOST_CUTS || visible > 1) {
      const none: readonly number[] = [];
      return (row) => cuts.get(row) ?? none;
    }
  }
}

/** Gives every chord its colour, and says what the colours mean. Names are left to the caller as keys. */
export function paint(app: App, lines: Lines, theme: Theme, by: ColourBy): Legend {
  const { colours, rows, kinds, count } = lines;
  lines.dashes = undefined;
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
    const values = new Set<number | null>();
    each((row) => {
      values.add(of(row));
      return 0;
    });
    const sorted = [...values].sort((a, b) => (a ?? -1) - (b ?? -1));
    const looks = new Map(sorted.filter((value) => value !== null).map((value, place) => [value, look(place, theme)]));
    const looksOf = (value: number | null): { colour: number; dash: Dash } =>
      (value === null ? undefined : looks.get(value)) ?? { colour: theme.kinds[0]!, dash: Dash.Solid };
    each((row) => looksOf(of(row)).colour);
    if ([...looks.values()].some(({ dash }) => dash !== Dash.Solid)) {
      lines.dashes = new Uint8Array(count);
      for (let chord = 0; chord < count; chord += 1) {
        lines.dashes[chord] = looksOf(of(rows[chord]!)).dash;
      }
    }
    // Beyond 48 names looks repeat: those that look alike stand together.
    const items: { name: string; colour: number; dash: Dash }[] = [];
    for (const value of sorted) {
      const { colour, dash } = looksOf(value);
      const same = value === null ? undefined : items.find((item) => item.colour === colour && item.dash === dash);
      if (same === undefined) {
        items.push({ name: name(value), colour, dash });
      } else {
        same.name += `, ${name(value)}`;
      }
    }
    return { kind: 'names', items };
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
        dash: kind === 0 ? Dash.Rapid : Dash.Solid,
      }));
      return { kind: 'names', items };
    }
    case 'change': {
      const { comparison } = app;
      if (comparison === undefined) {
        return { kind: 'names', items: [] };
      }
      paintHalf(comparison, 'new', lines, theme);
      const items = [
        { name: 'inNew', colour: theme.kinds[2]!, dash: Dash.Solid },
        { name: 'inOld', colour: theme.old, dash: Dash.Long },
        { name: 'otherValues', colour: theme.values, dash: Dash.Solid },
        { name: 'asBefore', colour: theme.asBefore, dash: Dash.Solid },
      ];
      return { kind: 'names', items };
    }
    case 'tool':
      return byName(
        (row) => state(row, 'tool'),
        (tool) => (tool === null ? '' : `T${tool}`),
      );
    case 'set':
      return byName(
        (row) => state(row, 'dynamic_set') ?? 1,
        (set) => String(set),
      );
    case 'feed': {
      // What feeds count is told apart: a millimetre a revolution is not one a minute.
      const units = new Map<string, { low: number; high: number }>();
      const isRapid = (row: number): boolean => lines.path.kind(row) === 0;
      const fed = program.header.states.map((state) => ({
        unit: String(state['feed_unit'] ?? ''),
        scale: (typeof state['feed_scale'] === 'number' ? state['feed_scale'] : 1) / 1000,
      }));
      for (let chord = 0; chord < count; chord += 1) {
        const row = rows[chord]!;
        if (kinds[chord] !== 0 && program.feed[row]! > 0) {
          const { unit, scale } = fed[program.state[row]!]!;
          const value = program.feed[row]! * scale;
          const range = units.get(unit) ?? { low: value, high: value };
          range.low = Math.min(range.low, value);
          range.high = Math.max(range.high, value);
          units.set(unit, range);
        }
      }
      const order = [...units.keys()];
      each((row) => {
        const { unit, scale } = fed[program.state[row]!]!;
        const range = units.get(unit);
        if (isRapid(row) || program.feed[row]! === 0 || range === undefined) {
          return theme.kinds[0]!;
        }
        const { low, high } = range;
        return scaled((program.feed[row]! * scale - low) / (high > low ? high - low : 1), theme, order.indexOf(unit));
      });
      return {
        kind: 'scale',
        scales: order.map((unit) => ({ from: units.get(unit)!.low, to: units.get(unit)!.high, unit })),
      };
    }
    case 'depth': {
      const box = lines.path.workingBox ?? lines.path.box;
      const [low, high] = [box.min[2], box.max[2]];
      const at = (z: number): number => scaled((z + lines.origin[2] - low) / (high > low ? high - low : 1), theme);
      for (let chord = 0; chord < count; chord += 1) {
        const rapid = kinds[chord] === 0;
        colours[2 * chord] = rapid ? theme.kinds[0]! : at(lines.points[6 * chord + 2]!);
        colours[2 * chord + 1] = rapid ? theme.kinds[0]! : at(lines.points[6 * chord + 5]!);
      }
      return { kind: 'scale', scales: [{ from: low, to: high, unit: 'mm' }] };
    }
    case 'time': {
      const total = times?.total ?? program.count;
      each((row) => {
        const index = program.firstIndexOf(row);
        return scaled((times?.startOf(index) ?? index) / (total || 1), theme);
      });
      return { kind: 'scale', scales: [{ from: 0, to: total, unit: times === undefined ? 'N' : 's' }] };
    }
    case 'velocity': {
      if (times === undefined) {
        each(() => theme.kinds[0]!);
        return { kind: 'names', items: [] };
      }
      const most = fastest(app);
      const high = most || 1;
      let row = -1;
      let share = 0;
      let ramps: ReturnType<typeof times.ramps>;
      const at = (way: number): number => {
        const { start, peak, end, rise, fall } = ramps!;
        const [slow, part] = way < rise ? [start, way / rise] : way > 1 - fall ? [end, (1 - way) / fall] : [peak, 1];
        return scaled(Math.sqrt(slow * slow + (peak * peak - slow * slow) * part) / high, theme);
      };
      for (let chord = 0; chord < count; chord += 1) {
        if (rows[chord] !== row) {
          row = rows[chord]!;
          share = 0;
          ramps = times.ramps(program.firstIndexOf(row));
        }
        const next = lines.ends?.[chord] ?? 1;
        colours[2 * chord] = ramps === undefined ? theme.kinds[0]! : at(share);
        colours[2 * chord + 1] = ramps === undefined ? theme.kinds[0]! : at(next);
        share = next;
      }
      return { kind: 'scale', scales: [{ from: 0, to: most, unit: 'mm/min' }] };
    }
  }
}

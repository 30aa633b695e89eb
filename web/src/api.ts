// What scripts and embedding pages may ask of the page: `window.cnc872c`, and messages.

import type { App, ColourBy } from './app.ts';
import type { Side } from './data/compared.ts';
import type { Fields } from './data/header.ts';
import type { Lang } from './i18n.ts';
import type { Standard, View } from './scene/view.ts';
import { showChange } from './ui/changes.ts';
import type { Player } from './ui/player.ts';
import { currentRecord } from './ui/state.ts';

export interface Api {
  /** The path is drawn. */
  ready: Promise<void>;
  info(): { blocks: number; segments: number; drawn: number; from: number; left_out: number };
  select(seq: number): boolean;
  current(): Fields | null;
  pick(x: number, y: number): number | null;
  /** `side`: of which of two compared programs. */
  project(seq: number, side?: Side): { x: number; y: number } | null;
  /** What two programs do differently, as `cnc872c compare --format json` says it; empty on other pages. */
  changes(): Fields[];
  /** Shows a change, by its place in `changes()`. */
  change(place: number): boolean;
  dots(): { seq: number; n: number; dot: string; reason?: string; feed: number; angle_deg?: number }[];
  colour(by: string): void;
  view(plane: string): void;
  play(speed?: number): void;
  stop(): void;
  language(lang: string): void;
}

const VIEWS = ['XY', 'XZ', 'YZ', 'ZX', 'iso', 'fit'];

export function api(
  app: App,
  view: View,
  player: Player,
  setLanguage: (lang: Lang) => void,
  ready: Promise<void>,
): Api {
  const indexOf = (seq: unknown, program = app.program): number | undefined => {
    const index = typeof seq === 'number' && Number.isInteger(seq) ? seq - program.from : -1;
    return index >= 0 && index < program.count ? index : undefined;
  };
  return {
    ready,
    info: () => ({
      blocks: app.header.blocks,
      segments: app.path.segments,
      drawn: drawn(app, view),
      from: app.program.from,
      left_out: app.header.blocks - app.program.count + app.path.unknown,
    }),
    select: (seq) => {
      const index = indexOf(seq);
      if (index === undefined) {
        return false;
      }
      app.select(index, 'script');
      return true;
    },
    current: () => currentRecord(app),
    pick: (x, y) => {
      const index = view.pick(Number(x), Number(y));
      return index === null ? null : app.program.from + index;
    },
    project: (seq, side = 'new') => {
      const { program, path } = side === 'old' ? (app.comparison?.old ?? app) : app;
      const index = indexOf(seq, program);
      const row = index === undefined ? -1 : program.rowOf(index);
      return row >= 0 && path.hasLine(row) && path.isKnown(row) ? view.camera.project(path.at(row, 0.5)) : null;
    },
    changes: () => app.comparison?.compared.changes ?? [],
    change: (place) => {
      const known = Number.isInteger(place) && place >= 0 && place < (app.comparison?.count ?? 0);
      if (known) {
        showChange(app, view, place);
      }
      return known;
    },
    dots: () =>
      Array.from(app.times?.dots() ?? [], (index) => {
        const place = app.place(index);
        const joint = app.times!.joint(index)!;
        const reason = joint.broken_by ?? joint.limited_by;
        return {
          seq: place.seq,
          n: app.program.n[place.block]!,
          dot: app.times!.dotOf(index)!,
          ...(reason === undefined ? {} : { reason }),
          feed: joint.feed,
          ...(joint.angle_deg === undefined ? {} : { angle_deg: joint.angle_deg }),
        };
      }),
    colour: (by) => {
      if (!(app.colours as string[]).includes(by)) {
        throw new RangeError(`colour: ${app.colours.join(', ')}`);
      }
      app.colourBy = by as ColourBy;
      app.emit('colour', undefined);
    },
    view: (plane) => {
      if (!VIEWS.includes(plane)) {
        throw new RangeError(`view: ${VIEWS.join(', ')}`);
      }
      view.look(plane as Standard);
    },
    play: (speed = 1) => {
      if (!(Number(speed) > 0)) {
        throw new RangeError('play: a speed above 0');
      }
      player.play(Number(speed));
    },
    stop: () => player.stop(),
    language: (lang) => {
      if (lang !== 'en' && lang !== 'cs') {
        throw new RangeError('language: en, cs');
      }
      setLanguage(lang);
    },
  };
}

/** Executed blocks with a line that is drawn now. */
function drawn(app: App, view: View): number {
  if (!app.isFiltered) {
    return app.path.segments;
  }
  let count = 0;
  for (let index = 0; index < app.program.count; index += 1) {
    const row = app.program.rowOf(index);
    const rapid = !app.shown.rapids && app.path.kind(row) === 0;
    if (!rapid && !app.isHidden(index) && view.app.path.hasLine(row)) {
      count += 1;
    }
  }
  return count;
}

/** Tells of each change of the block in hand, and answers the page's own parent. */
export function connect(app: App, answers: Api): void {
  const parent = window.parent === window ? undefined : window.parent;
  app.on('select', ({ index }) => {
    if (index !== null) {
      const { seq, file, line } = app.place(index);
      const detail = { seq, file, line };
      window.dispatchEvent(new CustomEvent('cnc872c:select', { detail }));
      parent?.postMessage({ cnc872c: 'select', detail }, '*');
    }
  });
  window.addEventListener('message', (event) => {
    const message = event.data as { cnc872c?: unknown; args?: unknown; id?: unknown } | null;
    if (parent === undefined || event.source !== parent || typeof message?.cnc872c !== 'string') {
      return;
    }
    const { cnc872c: name, id } = message;
    const answer = (more: object): void => parent.postMessage({ cnc872c: name, id, ...more }, '*');
    const failed = (error: unknown): void => answer({ error: error instanceof Error ? error.message : String(error) });
    if (!Object.hasOwn(answers, name)) {
      failed(`no such name: ${name}`);
      return;
    }
    try {
      const member = answers[name as keyof Api];
      const args = Array.isArray(message.args) ? (message.args as never[]) : [];
      const result: unknown = member instanceof Promise ? member : (member as (...args: never[]) => unknown)(...args);
      if (result instanceof Promise) {
        result.then((value: unknown) => answer({ result: value ?? null }), failed);
      } else {
        answer({ result: result ?? null });
      }
    } catch (error) {
      failed(error);
    }
  });
}

// Distances, boxes, path and time of a stretch.

import type { App } from '../app.ts';
import type { Size } from '../data/header.ts';
import { type Key, t } from '../i18n.ts';
import type { View } from '../scene/view.ts';
import { clock, h, idle, least, rebuild, shown } from './dom.ts';

export function measure(app: App, view: View): HTMLElement {
  const element = h('div', { class: 'measure' });
  let stretch: { from: number; to: number } | undefined;
  const box = (key: Key, { axes, lacks }: Size): HTMLElement => {
    const letters = ['X', 'Y', 'Z'].filter((letter) => letter in axes);
    const title = lacks === '' ? t(key) : `${t(key)}, ${t('lowerBound')}`;
    if (letters.length === 0) {
      return h('section', {}, h('h2', {}, title), h('p', { class: 'empty' }, t('noMotions')));
    }
    const { diameter } = app.header;
    const rows = letters.map((letter) => {
      const [min, max] = axes[letter]!;
      // As the picture's axis counts.
      const [name, times] = letter === 'X' && diameter ? ['ØX', 2] : [letter, 1];
      const values = [min, max, max - min].map((value) => h('td', {}, shown(times * value)));
      return h('tr', {}, h('th', { scope: 'row' }, name), ...values);
    });
    const head = ['', t('from'), t('to'), t('size')].map((name) =>
      name === '' ? h('td') : h('th', { scope: 'col' }, name),
    );
    return h('table', {}, h('caption', {}, title), h('tr', {}, ...head), ...rows);
  };
  const tell = (): void => {
    const { working, all } = app.header.size;
    const { measured } = view;
    const distance = h('section', {}, h('h2', {}, t('distance')));
    if (measured.length === 2) {
      const [a, b] = [measured[0]!.point, measured[1]!.point];
      const apart = a.map((value, i) => Math.abs(b[i]! - value));
      const parts = apart.map(shown);
      const also = app.header.diameter ? ` (Ø ${shown(2 * apart[0]!)})` : '';
      distance.append(
        h('p', { class: 'result' }, `${shown(Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]))} mm`),
        h('p', {}, `ΔX ${parts[0]}${also} · ΔY ${parts[1]} · ΔZ ${parts[2]}`),
      );
    } else if (view.onPoint !== undefined) {
      distance.append(h('p', {}, t(measured.length === 0 ? 'pickFirst' : 'pickSecond')));
    }
    distance.append(
      h(
        'button',
        {
          type: 'button',
          'data-focus': 'pick',
          'aria-pressed': String(view.onPoint !== undefined),
          onclick: pickPoints,
        },
        t('pickPoints'),
      ),
      h(
        'button',
        { type: 'button', 'data-focus': 'clear', onclick: clear, ...idle(measured.length === 0) },
        t('clear'),
      ),
    );
    rebuild(element, distance, stretchPart(), box('boxWorking', working), box('boxAll', all));
  };
  const pickPoints = (): void => {
    view.measured = [];
    view.onPoint = (point) => {
      view.measured = [...view.measured, point];
      if (view.measured.length === 2) {
        view.onPoint = undefined;
      }
      view.request('marks');
      tell();
    };
    view.request('marks');
    tell();
  };
  const clear = (): void => {
    view.measured = [];
    view.onPoint = undefined;
    view.request('marks');
    tell();
  };
  const stretchPart = (): HTMLElement => {
    const section = h('section', {}, h('h2', {}, t('stretch')));
    const set = (end: 'from' | 'to') => (): void => {
      if (app.current !== null) {
        stretch = { from: app.current, to: app.current, ...stretch, [end]: app.current };
        tell();
      }
    };
    if (stretch !== undefined) {
      const [from, to] = [Math.min(stretch.from, stretch.to), Math.max(stretch.from, stretch.to)];
      const { program, times } = app;
      let [length, isShort, isBrief] = [0, false, false];
      for (let index = from; index <= to; index += 1) {
        const way = program.way(program.rowOf(index));
        length += way ?? 0;
        isShort ||= way === undefined;
        isBrief ||= times?.isUnknown(index) === true;
      }
      const n = (index: number): string => `N${program.n[app.place(index).block]!}`;
      const rows: [string, string][] = [
        [`${n(from)} … ${n(to)}`, t('blockCount', { n: to - from + 1 })],
        [t('pathLength'), least(`${shown(length)} mm`, isShort)],
      ];
      if (times !== undefined) {
        const time = times.startOf(to) + times.durationOf(to) - times.startOf(from);
        rows.push([t('time'), least(clock(time), isBrief)]);
      }
      section.append(h('dl', {}, ...rows.flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)])));
    }
    section.append(
      h(
        'button',
        { type: 'button', 'data-focus': 'from', onclick: set('from'), ...idle(app.current === null) },
        t('setFrom'),
      ),
      h(
        'button',
        { type: 'button', 'data-focus': 'to', onclick: set('to'), ...idle(app.current === null) },
        t('setTo'),
      ),
    );
    return section;
  };
  tell();
  app.on('data', () => {
    stretch = undefined;
    tell();
  });
  app.on('language', tell);
  app.on('select', ({ by }) => {
    if (by !== 'play') {
      tell();
    }
  });
  return element;
}

// The bar above the path: views, colours, what is shown, language, help.

import type { App, ColourBy, Shown } from '../app.ts';
import { type Key, language, t } from '../i18n.ts';
import { css } from '../scene/colours.ts';
import type { Standard, View } from '../scene/view.ts';
import { clock, h, labelled, least, local, said } from './dom.ts';

export function title(app: App): HTMLElement {
  const heading = h('h1');
  const facts = h('p', { class: 'facts' });
  const tell = (): void => {
    const { program, total } = app.header;
    const { number, title } = program;
    heading.replaceChildren(title === undefined ? `%${number}` : `%${number} ${title}`);
    document.title = `${heading.textContent} – ${program.name}`;
    const time = total?.['time_s'];
    const approach = total?.['without_approach'] === true ? `, ${t('withoutApproach')}` : '';
    facts.title = program.name;
    const parts = [program.name.split(/[/\\]/).pop() ?? '', t('blockCount', { n: local(app.header.blocks) })];
    if (typeof time === 'number') {
      parts.push(least(clock(time), total?.['at_least'] === true) + approach);
    }
    facts.textContent = parts.join(' · ');
  };
  tell();
  app.on('data', tell);
  app.on('language', tell);
  return h('div', { class: 'title' }, heading, facts);
}

export function toolbar(app: App, view: View, setLanguage: (lang: 'en' | 'cs') => void, help: () => void): HTMLElement {
  const planes = (['XY', 'XZ', 'YZ', 'ZX', 'iso', 'fit'] as Standard[]).map((standard) => {
    const look = (): void => view.look(standard, 'work');
    return standard === 'iso' || standard === 'fit'
      ? said('button', standard, { type: 'button', onclick: look })
      : h('button', { type: 'button', onclick: look }, standard);
  });
  const colours = h('select', { id: 'colour' });
  for (const by of app.colours) {
    colours.append(said('option', by as Key, { value: by }));
  }
  colours.value = app.colourBy;
  colours.addEventListener('change', () => {
    app.colourBy = colours.value as ColourBy;
    app.emit('colour', undefined);
  });
  app.on('colour', () => {
    colours.value = app.colourBy;
  });
  const toggles: [keyof Shown, Key][] = [
    ['red', 'redDots'],
    ['yellow', 'yellowDots'],
    ['numbers', 'numbers'],
    ['rapids', 'rapids'],
    ['grid', 'grid'],
    ['equidistant', 'equidistant'],
    ['old', 'oldPath'],
  ];
  const boxes = toggles.map(([what, key]) => {
    const box = h('input', { type: 'checkbox' });
    box.checked = app.shown[what];
    box.addEventListener('change', () => {
      app.shown[what] = box.checked;
      app.emit('shown', undefined);
    });
    const label = h('label', {}, box, said('span', key));
    const suit = (): void => {
      label.hidden =
        (what === 'equidistant' && app.header.equidistant === undefined) ||
        (what === 'old' && app.comparison === undefined) ||
        ((what === 'red' || what === 'yellow' || what === 'numbers') && app.times === undefined);
    };
    suit();
    app.on('data', suit);
    return label;
  });
  const languages = (['en', 'cs'] as const).map((lang) => {
    const name = lang === 'en' ? 'English' : 'Čeština';
    const button = h(
      'button',
      {
        type: 'button',
        lang,
        title: name,
        'aria-label': `${lang.toUpperCase()}: ${name}`,
        onclick: () => setLanguage(lang),
      },
      lang.toUpperCase(),
    );
    const press = (): void => button.setAttribute('aria-pressed', String(language() === lang));
    press();
    app.on('language', press);
    return button;
  });
  return h(
    'div',
    { class: 'toolbar' },
    labelled(h('div', { class: 'group', role: 'group' }, ...planes), 'view'),
    h('label', { class: 'group', for: 'colour' }, said('span', 'colourBy'), colours),
    labelled(h('div', { class: 'group', role: 'group' }, ...boxes), 'show'),
    h('span', { class: 'gap' }),
    labelled(h('div', { class: 'group languages', role: 'group' }, ...languages), 'language'),
    said('button', 'help', { type: 'button', onclick: help }),
  );
}

/** Names in a legend that have a text. */
const NAMED = new Set(['rapid', 'linear', 'arc', 'thread', 'inNew', 'inOld', 'otherValues', 'asBefore']);

/** What colours mean, and what is not drawn. */
export function legend(app: App, view: View): HTMLElement {
  const list = h('div', { class: 'legend' });
  const notes = h('div', { class: 'notes', role: 'status' });
  const now = h('p', { class: 'now', role: 'status' });
  let facts = { thinned: false, yellowHidden: false };
  const tell = (): void => {
    const { legend } = view;
    list.replaceChildren();
    if (legend.kind === 'names') {
      for (const item of legend.items) {
        const mark = h('span', { class: `swatch dash-${item.dash}` });
        mark.style.setProperty('--colour', css(item.colour));
        const name = item.name === '' ? t('noTool') : NAMED.has(item.name) ? t(item.name as Key) : item.name;
        list.append(h('span', { class: 'item' }, mark, name));
      }
    } else {
      legend.scales.forEach(({ from, to, unit }, which) => {
        const ends = unit === 's' ? [clock(from), clock(to)] : [local(from), `${local(to)} ${unit}`];
        const scale = h('span', { class: which % 2 === 0 ? 'scale' : 'scale other' });
        list.append(h('span', { class: 'item' }, ends[0]!, scale, ends[1]!));
      });
    }
    const { equidistant } = app.header;
    if (equidistant !== undefined && app.shown.equidistant) {
      const swatch = (colour: number, key: Key): void => {
        const mark = h('span', { class: 'swatch thin' });
        mark.style.setProperty('--colour', css(colour));
        list.append(h('span', { class: 'item' }, mark, t(key)));
      };
      swatch(view.theme.equidistant, 'equidistant');
      if (equidistant.pieces.some((piece) => piece.bad)) {
        swatch(view.theme.collision, 'collides');
      }
    }
  };
  const tellNotes = (): void => {
    const { header, path, program } = app;
    const said: string[] = [];
    if (!header.whole) {
      said.push(t(header.count > 0 ? 'notWhole' : 'notDrawn'));
    } else if (header.count === 0 && header.blocks > 0) {
      said.push(t('partNone', { n: header.blocks }));
    }
    if (header.count > 0 && header.count < header.blocks) {
      said.push(t('part', { from: program.from, to: program.from + header.count - 1, n: header.blocks }));
    }
    if (app.stale) {
      said.push(t('stale'));
    }
    if (path.unknown > 0) {
      said.push(t('unknownLines', { n: path.unknown }));
    }
    if (path.stale > 0) {
      said.push(t('staleLines', { n: path.stale }));
    }
    const moved = new Set(header.shapes.flatMap((shape) => (shape.m?.['axes'] ?? []) as string[]));
    const others = (kind: string): string =>
      header.program.axes
        .filter((axis) => moved.has(axis.letter) && axis.kind === kind && !'XYZ'.includes(axis.letter))
        .map((axis) => axis.letter)
        .join(', ');
    for (const [kind, key] of [
      ['linear', 'otherLinear'],
      ['rotary', 'rotary'],
    ] as const) {
      if (others(kind) !== '') {
        said.push(t(key, { axes: others(kind) }));
      }
    }
    if (header.machine?.['assumed'] === true) {
      said.push(t('assumed'));
    }
    notes.replaceChildren(...said.map((line) => h('p', {}, line)));
  };
  /** What is so only now. The bar has room for it always, so that the picture keeps its size. */
  const tellNow = (): void => {
    const said = [facts.yellowHidden ? t('yellowLater') : '', facts.thinned ? t('thinned') : ''].filter(
      (text) => text !== '',
    );
    now.textContent = said.join(' · ');
  };
  view.onLegend = tell;
  view.onDrawn = (drawn) => {
    if (drawn.thinned !== facts.thinned || drawn.yellowHidden !== facts.yellowHidden) {
      facts = drawn;
      tellNow();
    }
  };
  const both = (): void => {
    tell();
    tellNotes();
    tellNow();
  };
  both();
  app.on('data', both);
  app.on('stale', both);
  app.on('language', both);
  return h('div', { class: 'about' }, notes, h('div', { class: 'legends' }, list, now));
}

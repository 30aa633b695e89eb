// The bar above the path: views, colours, what is shown, language, help.

import { type App, COLOURS, type ColourBy, type Shown } from '../app.ts';
import { type Key, language, t } from '../i18n.ts';
import { css } from '../scene/colours.ts';
import type { Standard, View } from '../scene/view.ts';
import { clock, h, labelled, said, shown } from './dom.ts';

export function title(app: App): HTMLElement {
  const heading = h('h1');
  const facts = h('p', { class: 'facts' });
  const tell = (): void => {
    const { program, total } = app.header;
    heading.replaceChildren(program.title === undefined ? `%${program.number}` : `%${program.number} ${program.title}`);
    document.title = `${heading.textContent} – ${program.name}`;
    const time = total?.['time_s'];
    const bound = total?.['lower_bound'] === true ? `${t('lowerBound')} ` : '';
    facts.title = program.name;
    const parts = [program.name.split(/[/\\]/).pop() ?? '', `${app.header.blocks.toLocaleString(language())} ${t('blocks')}`];
    if (typeof time === 'number') {
      parts.push(bound + clock(time));
    }
    facts.textContent = parts.join(' · ');
  };
  tell();
  app.on('data', tell);
  app.on('language', tell);
  return h('div', { class: 'title' }, heading, facts);
}

export function toolbar(app: App, view: View, setLanguage: (lang: 'en' | 'cs') => void, help: () => void): HTMLElement {
  const planes = (['XY', 'XZ', 'YZ', 'iso', 'fit'] as Standard[]).map((standard) => {
    const look = (): void => view.look(standard);
    return standard === 'iso' || standard === 'fit'
      ? said('button', standard, { type: 'button', onclick: look })
      : h('button', { type: 'button', onclick: look }, standard);
  });
  const colours = h('select', { id: 'colour' });
  for (const by of COLOURS) {
    colours.append(said('option', by as Key, { value: by }));
  }
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
        ((what === 'red' || what === 'yellow' || what === 'numbers') && app.times === undefined);
    };
    suit();
    app.on('data', suit);
    return label;
  });
  const languages = (['en', 'cs'] as const).map((lang) => {
    const name = lang === 'en' ? 'English' : 'Čeština';
    const button = h('button', { type: 'button', lang, title: name, 'aria-label': `${lang.toUpperCase()}: ${name}`, onclick: () => setLanguage(lang) }, lang.toUpperCase());
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

/** What colours mean, and what is not drawn. */
export function legend(app: App, view: View): HTMLElement {
  const list = h('div', { class: 'legend' });
  const notes = h('div', { class: 'notes', role: 'status' });
  let facts = { thinned: false, yellowHidden: false };
  const tell = (): void => {
    const { legend } = view;
    list.replaceChildren();
    if (legend.kind === 'names') {
      for (const item of legend.items) {
        const mark = h('span', { class: item.dashed ? 'swatch dashed' : 'swatch' });
        mark.style.setProperty('--colour', css(item.colour));
        const name = item.name === '' ? t('noTool') : item.name in { rapid: 1, linear: 1, arc: 1, thread: 1 } ? t(item.name as Key) : item.name;
        list.append(h('span', { class: 'item' }, mark, name));
      }
    } else if (Number.isFinite(legend.from)) {
      const ends = legend.unit === 's' ? [clock(legend.from), clock(legend.to)] : [shown(legend.from, 1), `${shown(legend.to, 1)} ${legend.unit}`];
      list.append(h('span', { class: 'item' }, ends[0]!, h('span', { class: 'scale' }), ends[1]!));
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
    if (header.count < header.blocks) {
      said.push(t('part', { from: program.from, to: program.from + Math.max(header.count - 1, 0), n: header.blocks }));
    }
    if (!header.whole) {
      said.push(t('notWhole'));
    }
    if (app.stale) {
      said.push(t('stale'));
    }
    if (path.unknown > 0) {
      said.push(t('unknownLines', { n: path.unknown }));
    }
    const rotary = header.program.axes.filter((axis) => axis.kind === 'rotary').map((axis) => axis.letter);
    const moved = rotary.filter((letter) => header.shapes.some((shape) => ((shape.m?.['axes'] ?? []) as string[]).includes(letter)));
    if (moved.length > 0) {
      said.push(t('rotary', { axes: moved.join(', ') }));
    }
    if (header.machine?.['assumed'] === true) {
      said.push(t('assumed'));
    }
    if (facts.yellowHidden) {
      said.push(t('yellowLater'));
    }
    if (facts.thinned) {
      said.push(t('thinned'));
    }
    const text = said.join('\n');
    if (notes.textContent !== text) {
      notes.replaceChildren(...said.map((line) => h('p', {}, line)));
    }
  };
  view.onLegend = tell;
  view.onDrawn = (now) => {
    if (now.thinned !== facts.thinned || now.yellowHidden !== facts.yellowHidden) {
      facts = now;
      tellNotes();
    }
  };
  const both = (): void => {
    tell();
    tellNotes();
  };
  both();
  app.on('data', both);
  app.on('stale', both);
  app.on('language', both);
  return h('div', { class: 'overlay' }, notes, list);
}

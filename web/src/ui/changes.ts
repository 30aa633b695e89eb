// What two programs do differently: a list that leads to each change.

import type { App } from '../app.ts';
import type { Comparison } from '../data/compared.ts';
import { language, t } from '../i18n.ts';
import type { View } from '../scene/view.ts';
import { h, rebuild } from './dom.ts';

/** So many changes are listed at once; a button shows more. */
const AT_ONCE = 300;

/** Shows a change, with its first place in sight. */
export function showChange(app: App, view: View, change: number): void {
  app.choose(change);
  const { comparison } = app;
  for (const side of ['new', 'old'] as const) {
    const first = comparison?.runs(change, side)[0]?.[0];
    if (comparison !== undefined && first !== undefined) {
      const { program, path } = comparison[side];
      view.reveal(path.point(program.rowOf(first - program.from)));
      return;
    }
  }
}

/** What both programs take, and the changes. */
export function changes(app: App, comparison: Comparison, view: View): HTMLElement {
  const element = h('div', { class: 'changes' });
  const { compared, count } = comparison;
  let listed = AT_ONCE;
  const tell = (): void => {
    const lang = language();
    const names = [compared.old, compared.new].map((side) => String(side['name'] ?? ''));
    const head = [names.join(' → '), ...compared.head[lang]].map((line) => h('p', {}, line));
    const items = Array.from({ length: Math.min(count, listed) }, (_, place) => {
      const kind = String(compared.changes[place]?.['kind'] ?? '');
      const text = compared.texts[lang][place] ?? t('moreChanges', { n: Number(compared.rest?.['count']) });
      const show = (): void => showChange(app, view, place);
      return h('li', { class: kind }, h('button', { type: 'button', 'data-change': place, onclick: show }, text));
    });
    const further = h(
      'button',
      { type: 'button', class: 'more', onclick: () => more() },
      t('more', { n: count - listed }),
    );
    const list = h('ol', { 'aria-label': t('changes') }, ...items);
    rebuild(element, ...head, ...(count > 0 ? [list] : []), ...(count > listed ? [further] : []));
    mark();
  };
  const more = (): void => {
    listed *= 4;
    tell();
  };
  const mark = (): void => {
    const { chosen } = comparison;
    for (const button of element.querySelectorAll('[data-change]')) {
      button.toggleAttribute('aria-current', button.getAttribute('data-change') === String(chosen));
    }
  };
  // A block in hand shows the change that it is in.
  app.on('select', ({ index, by }) => {
    if (index !== null && by !== 'play' && comparison.chosen !== null) {
      const [chosen, at] = [comparison.chosen, app.program.from + index];
      if (!comparison.runs(chosen, 'new').some(([from, to]) => from <= at && at <= to)) {
        comparison.chosen = comparison.changeAt(index);
        app.emit('change', undefined);
      }
    }
  });
  app.on('change', mark);
  app.on('language', tell);
  tell();
  return element;
}

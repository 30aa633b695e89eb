// Parts of the page of which one is seen at a time.

import type { Key } from '../i18n.ts';
import { h, labelled, said } from './dom.ts';

export function tabs(name: Key, parts: [Key, HTMLElement][]): HTMLElement {
  const buttons = parts.map(([key], place) =>
    said('button', key, {
      type: 'button',
      role: 'tab',
      id: `tab-${key}`,
      'aria-controls': `panel-${key}`,
      onclick: () => show(place),
    }),
  );
  const panels = parts.map(([key, content]) =>
    h('div', { role: 'tabpanel', id: `panel-${key}`, 'aria-labelledby': `tab-${key}`, tabindex: 0 }, content),
  );
  const show = (wanted: number): void => {
    buttons.forEach((button, place) => {
      button.setAttribute('aria-selected', String(place === wanted));
      button.tabIndex = place === wanted ? 0 : -1;
      panels[place]!.hidden = place !== wanted;
    });
  };
  const bar = labelled(h('div', { role: 'tablist', class: 'tabs' }, ...buttons), name);
  bar.addEventListener('keydown', (event) => {
    const at = buttons.indexOf(event.target as HTMLButtonElement);
    const by = event.key === 'ArrowRight' ? 1 : event.key === 'ArrowLeft' ? -1 : 0;
    if (at >= 0 && by !== 0) {
      const next = (at + by + buttons.length) % buttons.length;
      show(next);
      buttons[next]!.focus();
      event.preventDefault();
    }
  });
  show(0);
  return h('section', { class: 'details' }, bar, ...panels);
}

// Parts of the page of which one is seen at a time.

import { type Key, t } from '../i18n.ts';
import { h, labelled } from './dom.ts';

/** Parts by their names; `count` gives what stands behind a name. */
export function tabs(
  name: Key,
  parts: [Key, HTMLElement][],
  count: (key: Key) => number = () => 0,
): { element: HTMLElement; show: (key: Key) => void; tell: () => void } {
  const buttons = parts.map(([key], place) =>
    h('button', {
      type: 'button',
      role: 'tab',
      id: `tab-${key}`,
      'aria-controls': `panel-${key}`,
      onclick: () => show(place),
    }),
  );
  const tell = (): void =>
    buttons.forEach((button, place) => {
      const key = parts[place]![0];
      button.textContent = count(key) > 0 ? `${t(key)} (${count(key)})` : t(key);
    });
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
  tell();
  const element = h('section', { class: 'details' }, bar, ...panels);
  return { element, show: (wanted) => show(parts.findIndex(([key]) => key === wanted)), tell };
}

// The edge between path and text: it can be dragged, and moved by arrow keys.

import { h, labelled } from './dom.ts';

/** The least width of the path and of the text, in CSS pixels. */
const LEAST = 200;

export function divider(main: HTMLElement): HTMLElement {
  const edge = labelled(
    h('div', { class: 'divider', role: 'separator', 'aria-orientation': 'vertical', tabindex: 0 }),
    'divider',
  );
  const side = (): number => main.getBoundingClientRect().right - edge.getBoundingClientRect().right;
  const put = (width: number): void => {
    const most = Math.max(main.clientWidth - LEAST, LEAST);
    const wanted = Math.min(Math.max(width, LEAST), most);
    main.style.setProperty('--side', `${Math.round(wanted)}px`);
    edge.setAttribute('aria-valuenow', String(Math.round((100 * wanted) / Math.max(main.clientWidth, 1))));
  };
  edge.setAttribute('aria-valuenow', '30');
  edge.addEventListener('pointerdown', (event) => {
    edge.setPointerCapture(event.pointerId);
    event.preventDefault();
    edge.focus();
  });
  edge.addEventListener('pointermove', (event) => {
    if (edge.hasPointerCapture(event.pointerId)) {
      put(main.getBoundingClientRect().right - event.clientX);
    }
  });
  edge.addEventListener('keydown', (event) => {
    const by = event.key === 'ArrowLeft' ? 24 : event.key === 'ArrowRight' ? -24 : 0;
    if (by !== 0) {
      event.preventDefault();
      put(side() + by);
    }
  });
  return edge;
}

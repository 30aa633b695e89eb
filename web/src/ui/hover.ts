// Words beside the pointer: the block whose line it is over.

import type { App } from '../app.ts';
import { type Key, t } from '../i18n.ts';
import type { View } from '../scene/view.ts';
import { h, local } from './dom.ts';

/** N, motion, F and length of an executed block. */
export function words(app: App, index: number): string {
  const { program } = app;
  const row = program.rowOf(index);
  const record = program.record(index);
  const parts = [
    `N${program.n[program.block[row]!]!}`,
    t(String((record['motion'] as { type?: string } | undefined)?.type) as Key),
  ];
  if (app.path.kind(row) !== 0 && typeof record['feed'] === 'number') {
    const scale = typeof record['feed_scale'] === 'number' ? ` × ${local(record['feed_scale'])}` : '';
    parts.push(`F ${local(record['feed'], 3)}${scale} ${String(record['feed_unit'] ?? '')}`.trimEnd());
  }
  const length = program.lengthOf(row);
  parts.push(length > 0 ? `${local(length, 3)} ${program.turns(row) ? '°' : 'mm'}` : '');
  return parts.filter((part) => part !== '').join(' · ');
}

export function hover(app: App, view: View, stage: HTMLElement): void {
  const label = h('div', { class: 'hover', role: 'tooltip', hidden: true });
  stage.append(label);
  let at: { x: number; y: number } | undefined;
  let waits = false;
  const tell = (): void => {
    waits = false;
    const index = at === undefined || view.isMoving ? null : view.pick(at.x, at.y);
    label.hidden = index === null;
    if (at === undefined || index === null) {
      return;
    }
    label.textContent = words(app, index);
    const { width, height } = view.camera;
    const [wide, high] = [label.offsetWidth, label.offsetHeight];
    label.style.left = `${Math.max(Math.min(at.x + 14, width - wide - 4), 4)}px`;
    label.style.top = `${at.y + 18 + high > height ? Math.max(at.y - high - 10, 4) : at.y + 18}px`;
  };
  const move = (place: { x: number; y: number } | undefined): void => {
    at = place;
    if (!waits) {
      waits = true;
      requestAnimationFrame(tell);
    }
  };
  view.canvas.addEventListener('pointermove', (event) => {
    move(event.buttons === 0 && event.pointerType !== 'touch' ? { x: event.offsetX, y: event.offsetY } : undefined);
  });
  view.canvas.addEventListener('pointerdown', () => move(undefined));
  view.canvas.addEventListener('pointerleave', () => move(undefined));
}

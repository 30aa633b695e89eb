// What is shown of the path: tools, units, a range of blocks.

import type { App } from '../app.ts';
import { t } from '../i18n.ts';
import { h, rebuild } from './dom.ts';

export function filter(app: App): HTMLElement {
  const element = h('div', { class: 'filter' });
  const box = (name: string, checked: boolean, change: (on: boolean) => void): HTMLElement => {
    const input = h('input', { type: 'checkbox' });
    input.checked = checked;
    input.addEventListener('change', () => {
      change(input.checked);
      app.emit('filter', undefined);
    });
    return h('label', {}, input, h('span', {}, name));
  };
  const tell = (): void => {
    const { header, filter } = app;
    const tools = new Set<number | null>();
    for (const state of header.states) {
      const tool = state['tool'];
      tools.add(typeof tool === 'number' ? tool : null);
    }
    const sorted = [...tools].sort((a, b) => (a ?? -1) - (b ?? -1));
    const units = ['', ...new Set(header.calls.map((call) => `${call.by === 'G71' ? 'G71' : 'G72'} L${call.l}`))];
    const toggle =
      <V>(hidden: Set<V>, value: V) =>
      (on: boolean): void => {
        if (on) {
          hidden.delete(value);
        } else {
          hidden.add(value);
        }
      };
    const number = (end: 'from' | 'to'): HTMLInputElement => {
      const input = h('input', {
        type: 'number',
        min: app.program.from,
        max: app.program.from + Math.max(app.program.count - 1, 0),
        'aria-label': `${t('range')}: ${t(end)}`,
      });
      input.value = String(app.program.from + filter[end]);
      input.addEventListener('change', () => {
        const last = Math.max(app.program.count - 1, 0);
        filter[end] = Math.min(Math.max(Math.round(Number(input.value)) - app.program.from, 0), last);
        input.value = String(app.program.from + filter[end]);
        app.emit('filter', undefined);
      });
      return input;
    };
    const reset = (): void => {
      app.filter = { tools: new Set(), units: new Set(), from: 0, to: Math.max(app.program.count - 1, 0) };
      tell();
      app.emit('filter', undefined);
    };
    rebuild(
      element,
      h(
        'fieldset',
        {},
        h('legend', {}, t('tools')),
        ...sorted.map((tool) =>
          box(tool === null ? t('noTool') : `T${tool}`, !filter.tools.has(tool), toggle(filter.tools, tool)),
        ),
      ),
      h(
        'fieldset',
        {},
        h('legend', {}, t('units')),
        ...units.map((unit) =>
          box(unit === '' ? t('mainProgram') : unit, !filter.units.has(unit), toggle(filter.units, unit)),
        ),
      ),
      h('fieldset', {}, h('legend', {}, t('range')), number('from'), ' – ', number('to')),
      h('button', { type: 'button', 'data-focus': 'reset', onclick: reset }, t('reset')),
    );
  };
  tell();
  app.on('data', tell);
  app.on('language', tell);
  return element;
}

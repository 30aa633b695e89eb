// The red dots, and the findings.

import type { App } from '../app.ts';
import { named, t } from '../i18n.ts';
import type { View } from '../scene/view.ts';
import { h, rebuild, shown } from './dom.ts';

/** So many red dots are listed at once; a button shows more. */
const AT_ONCE = 300;

/** The red dots with number, angle, velocity, why, and what limits. */
export function joints(app: App, view: View): HTMLElement {
  const element = h('div', { class: 'joints' });
  let listed = AT_ONCE;
  const tell = (): void => {
    const { times, program } = app;
    if (times === undefined) {
      element.replaceChildren(h('p', { class: 'empty' }, t('noMotion')));
      return;
    }
    const red = times.redDots();
    if (red.length === 0) {
      element.replaceChildren(h('p', { class: 'empty' }, t('noRed')));
      return;
    }
    const items = Array.from(red.subarray(0, listed), (index) => {
      const joint = times.joint(index)!;
      const place = app.place(index);
      const row = program.rowOf(index);
      const reason = joint.broken_by ?? joint.limited_by;
      const why = reason === undefined ? '' : named(reason);
      const go = (): void => {
        app.select(index);
        view.reveal(app.path.start(row));
      };
      const facts = [
        joint.angle_deg === undefined ? '' : `${shown(joint.angle_deg, 1)}°`,
        `${shown(joint.feed, 0)} ${program.feedUnit(row)}`,
        why,
      ];
      const button = h(
        'button',
        { type: 'button', 'data-seq': place.seq, onclick: go },
        h('span', { class: 'n' }, `N${program.n[place.block]!}`),
        ...facts.map((fact) => h('span', {}, fact)),
      );
      return h('li', {}, button);
    });
    const list = h('ol', { 'aria-label': t('joints') }, ...items);
    const rest = red.length - listed;
    const further = h('button', { type: 'button', class: 'more', onclick: () => more() }, t('more', { n: rest }));
    rebuild(element, list, ...(rest > 0 ? [further] : []));
    mark();
  };
  const more = (): void => {
    listed *= 4;
    tell();
  };
  const mark = (): void => {
    const seq = app.current === null ? -1 : app.program.from + app.current;
    for (const button of element.querySelectorAll('[data-seq]')) {
      button.toggleAttribute('aria-current', button.getAttribute('data-seq') === String(seq));
    }
  };
  tell();
  app.on('data', tell);
  app.on('language', tell);
  app.on('select', mark);
  return element;
}

/** What the compiler found in the program. */
export function findings(app: App, view: View): HTMLElement {
  const element = h('div', { class: 'findings' });
  const tell = (): void => {
    const { findings, files } = app.header;
    if (findings.length === 0) {
      element.replaceChildren(h('p', { class: 'empty' }, t('noFindings')));
      return;
    }
    const lang = t('error') === 'error' ? 'en' : 'cs';
    const items = findings.map((finding) => {
      const name = finding.file === undefined ? finding.path : files[finding.file]?.name;
      const place = finding.line === undefined ? '' : `${name ?? ''}:${finding.line}:${finding.column ?? 1}`;
      const show = (): void => {
        const executions = finding.file === undefined ? [] : app.program.executionsAt(finding.file, finding.line ?? 0);
        if (executions.length > 0) {
          app.select(executions[0]!);
          view.reveal(app.path.point(app.program.rowOf(executions[0]!)));
        }
      };
      return h(
        'li',
        { class: finding.severity },
        h(
          'button',
          { type: 'button', onclick: show },
          h('span', { class: 'code' }, finding.code),
          h('span', { class: 'place' }, ` ${t(finding.severity)} ${place}`),
          h('span', { class: 'message' }, finding.message[lang]),
        ),
      );
    });
    rebuild(element, h('ul', { 'aria-label': t('findings') }, ...items));
  };
  tell();
  app.on('data', tell);
  app.on('language', tell);
  return element;
}

// Keys, hands, signs.

import { type Key, t } from '../i18n.ts';
import { h } from './dom.ts';

const KEYS: [string[], Key][] = [
  [['←', '→', '↑', '↓'], 'keyTurn'],
  [['Shift ←', '→', '↑', '↓'], 'keyPan'],
  [['+', '-'], 'keyZoom'],
  [['Home'], 'keyFit'],
  [[',', '.'], 'keyStep'],
  [['[', ']'], 'keyPass'],
  [['Space'], 'keyPlay'],
  [['?'], 'keyHelp'],
];

const CHART_KEYS: [string[], Key][] = [
  [['←', '→'], 'keyPan'],
  [['+', '-'], 'keyZoom'],
  [['Home'], 'keyFit'],
];

export class Help {
  readonly element = h('dialog', { class: 'help', 'aria-labelledby': 'help-title' });

  open(): void {
    const table = (rows: [string[], Key][]): HTMLElement => {
      const row = ([keys, key]: [string[], Key]): HTMLElement =>
        h('tr', {}, h('td', {}, ...keys.map((name) => h('kbd', {}, name))), h('td', {}, t(key)));
      return h('table', {}, ...rows.map(row));
    };
    const list = (keys: Key[]): HTMLElement => h('ul', {}, ...keys.map((key) => h('li', {}, t(key))));
    this.element.replaceChildren(
      h('h2', { id: 'help-title' }, t('help')),
      h('h3', {}, `${t('keys')}: ${t('keysPath')}`),
      table(KEYS),
      h('h3', {}, t('keysChart')),
      table(CHART_KEYS),
      h('h3', {}, t('mouse')),
      list(['mouseTurn', 'mousePan', 'mouseZoom', 'mousePick']),
      h('h3', {}, t('shapes')),
      list(['signRed', 'signYellow', 'signDashed']),
      h('form', { method: 'dialog' }, h('button', {}, t('close'))),
    );
    if (!this.element.open) {
      this.element.showModal();
    }
  }
}

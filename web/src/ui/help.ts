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

export class Help {
  readonly element = h('dialog', { class: 'help', 'aria-labelledby': 'help-title' });

  open(): void {
    const rows = KEYS.map(([keys, key]) =>
      h('tr', {}, h('td', {}, ...keys.map((name) => h('kbd', {}, name))), h('td', {}, t(key))),
    );
    const list = (keys: Key[]): HTMLElement => h('ul', {}, ...keys.map((key) => h('li', {}, t(key))));
    this.element.replaceChildren(
      h('h2', { id: 'help-title' }, t('help')),
      h('h3', {}, `${t('keys')}: ${t('keysPath')}`),
      h('table', {}, ...rows),
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

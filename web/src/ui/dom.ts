// Elements, with texts that follow the language.

import { type Key, language, t } from '../i18n.ts';

type Child = Node | string | null | undefined;
type Attributes = { [name: string]: string | number | boolean | ((event: never) => void) | undefined };

/** An element with attributes, listeners (`onclick`) and children. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === 'function') {
      element.addEventListener(name.slice(2), value as EventListener);
    } else if (value === true) {
      element.setAttribute(name, '');
    } else if (value !== undefined && value !== false) {
      element.setAttribute(name, String(value));
    }
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

/** An element whose text is that of a key. */
export function said<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  key: Key,
  attributes: Attributes = {},
): HTMLElementTagNameMap[K] {
  return h(tag, { ...attributes, 'data-t': key }, t(key));
}

/** An element whose accessible name is the text of a key. */
export function labelled<E extends HTMLElement>(element: E, key: Key): E {
  element.dataset['tLabel'] = key;
  element.setAttribute('aria-label', t(key));
  return element;
}

/** Gives every text of a part of the page the language in force. */
export function retell(root: ParentNode): void {
  for (const element of root.querySelectorAll<HTMLElement>('[data-t]')) {
    element.textContent = t(element.dataset['t'] as Key);
  }
  for (const element of root.querySelectorAll<HTMLElement>('[data-t-label]')) {
    element.setAttribute('aria-label', t(element.dataset['tLabel'] as Key));
  }
}

/** What a keyboard reaches in a part of the page. */
function controls(element: HTMLElement): HTMLElement[] {
  return [...element.querySelectorAll<HTMLElement>('button, input, select')];
}

/**
 * Gives a part of the page other children. The focus stays at the control with the same `data-focus`, else at the one in its
 * place, else at the panel.
 */
export function rebuild(element: HTMLElement, ...children: Node[]): void {
  const held = document.activeElement;
  const place = held === null ? -1 : controls(element).indexOf(held as HTMLElement);
  const name = place < 0 ? undefined : (held as HTMLElement).dataset['focus'];
  element.replaceChildren(...children);
  if (place < 0) {
    return;
  }
  const now = controls(element);
  const same =
    name === undefined
      ? now[Math.min(place, now.length - 1)]
      : now.find((control) => control.dataset['focus'] === name);
  (same ?? element.closest<HTMLElement>('[tabindex]'))?.focus({ preventScroll: true });
}

/** An attribute that keeps a control within reach of the keyboard while it does nothing. */
export function idle(on: boolean): { 'aria-disabled': 'true' | undefined } {
  return { 'aria-disabled': on ? 'true' : undefined };
}

/** A number as people read it: the smaller, the more decimals. */
export function brief(value: number): string {
  return shown(value, Math.abs(value) < 1 ? 4 : Math.abs(value) < 100 ? 2 : 1);
}

/** A number with at most so many decimals, without trailing zeros. */
export function shown(value: number, decimals = 3): string {
  return Number.isFinite(value) ? String(Number(value.toFixed(decimals))) : '–';
}

/**
 * A number with its digits in groups: by commas in English, by blanks in Czech. The decimal point is that of the control. As many
 * decimals as the size needs.
 */
export function local(value: number, decimals = Math.abs(value) < 1 ? 4 : Math.abs(value) < 100 ? 2 : 1): string {
  const text = value.toLocaleString('en-GB', { maximumFractionDigits: decimals });
  return language() === 'cs' ? text.replaceAll(',', '\u00a0') : text;
}

/** Seconds as h:mm:ss.s, or seconds alone when there are few. */
export function clock(seconds: number): string {
  if (Number(seconds.toFixed(2)) < 10) {
    return `${seconds.toFixed(2)} s`;
  }
  const tenths = Math.round(seconds * 10);
  if (tenths < 600) {
    return `${(tenths / 10).toFixed(1)} s`;
  }
  const whole = Math.floor(tenths / 10);
  const two = (value: number): string => String(value).padStart(2, '0');
  return `${Math.floor(whole / 3600)}:${two(Math.floor(whole / 60) % 60)}:${two(whole % 60)}.${tenths % 10}`;
}

/** A value that may be greater than is known. */
export function least(value: string, more: boolean): string {
  return more ? `${t('lowerBound')} ${value}` : value;
}

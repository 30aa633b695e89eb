// What holds at the block in hand, and how execution came to it.

import type { App } from '../app.ts';
import type { Fields } from '../data/header.ts';
import { quoted } from '../data/shell.ts';
import { type Key, named, t } from '../i18n.ts';
import { clock, h, idle, least, local, rebuild, shown } from './dom.ts';

/** The record of an executed block with that of its motion: one flat object. */
export function currentRecord(app: App): Fields | null {
  if (app.current === null) {
    return null;
  }
  const { program, times } = app;
  const block = program.block[program.rowOf(app.current)]!;
  const passes = program.executionsOf(block).filter((index) => index !== app.current);
  return {
    ...program.record(app.current),
    ...times?.record(app.current),
    passes: passes.map((index) => program.from + index),
  };
}

const two = (value: number): string => String(value).padStart(2, '0');
const at = (record: Fields, name: string): Fields => (record[name] ?? {}) as Fields;
const list = (record: Fields, name: string): number[] => (record[name] ?? []) as number[];

export class State {
  readonly element = h('div', { class: 'state' });
  readonly #app: App;
  #wanted = false;
  /** Whether the command of a restart is told. */
  #starts = false;

  constructor(app: App) {
    this.#app = app;
    const later = (): void => {
      if (!this.#wanted) {
        this.#wanted = true;
        requestAnimationFrame(() => {
          this.#wanted = false;
          this.#tell();
        });
      }
    };
    app.on('select', later);
    app.on('data', later);
    app.on('language', later);
    this.#tell();
  }

  #tell(): void {
    const record = currentRecord(this.#app);
    if (record === null) {
      rebuild(this.element, h('p', { class: 'empty' }, t('noBlock')));
      return;
    }
    const parts = [
      this.#head(record),
      this.#position(record),
      this.#functions(record, 'gGroups', 'G', list(record, 'g'), new Set(list(record, 'g_set'))),
      this.#functions(record, 'mGroups', 'M', list(record, 'm').slice(1), new Set(list(record, 'm_set'))),
      this.#words(record),
      this.#motion(record),
      this.#velocity(record),
      this.#parameters(),
      this.#ahead(),
      this.#restart(record),
    ];
    rebuild(this.element, ...parts.filter((part) => part !== null));
  }

  #section(key: Key, ...children: (Node | string)[]): HTMLElement {
    return h('section', {}, h('h2', {}, t(key)), ...children);
  }

  #rows(rows: [string, string][]): HTMLElement {
    return h('dl', {}, ...rows.flatMap(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]));
  }

  #head(record: Fields): HTMLElement {
    const { header } = this.#app;
    const file = header.files[record['file'] as number]!;
    const heading = h(
      'p',
      { class: 'which' },
      h('strong', {}, `N${String(record['n'])}`),
      ` · seq ${String(record['seq'])} · ${file.name}:${String(record['line'])}`,
    );
    const children: Node[] = [heading];
    const calls = (record['calls'] ?? []) as Fields[];
    if (calls.length > 0) {
      const items = calls.map((call) =>
        h(
          'li',
          {},
          `N${String(call['n'])} ${String(call['by'])} L${String(call['l'])}, ${t('pass')} ${String(call['pass'])} ${t('of')} ${String(call['of'])}`,
        ),
      );
      children.push(h('ol', { class: 'calls', 'aria-label': t('calls') }, ...items));
    }
    const passes = record['passes'] as number[];
    if (passes.length > 0) {
      const before = passes.filter((seq) => seq < (record['seq'] as number)).length;
      const text = t('executionOf', { i: before + 1, n: passes.length + 1 });
      const step =
        (by: number): (() => void) =>
        () =>
          this.#app.stepPass(by);
      children.push(
        h(
          'p',
          { class: 'passes' },
          h(
            'button',
            {
              type: 'button',
              'data-focus': 'previous',
              'aria-label': t('previousPass'),
              onclick: step(-1),
              ...idle(before === 0),
            },
            '[',
          ),
          ` ${text} `,
          h(
            'button',
            {
              type: 'button',
              'data-focus': 'next',
              'aria-label': t('nextPass'),
              onclick: step(1),
              ...idle(before === passes.length),
            },
            ']',
          ),
        ),
      );
    }
    const comments = (record['comments'] ?? []) as string[];
    if (comments.length > 0) {
      children.push(h('p', { class: 'comments' }, comments.join(' · ')));
    }
    return h('section', {}, ...children);
  }

  #position(record: Fields): HTMLElement {
    const position = at(record, 'position');
    const moved = new Set((at(record, 'motion')['axes'] ?? []) as string[]);
    const cells = this.#app.header.program.axes
      .filter(({ letter }) => letter in position || moved.has(letter))
      .map(({ letter, kind }) => {
        const value = position[letter];
        const text = typeof value === 'number' ? `${value.toFixed(3)}${kind === 'rotary' ? '°' : ''}` : t('unknown');
        // Positions are radii, also where X is programmed as a diameter.
        const diameter = letter === 'X' && typeof value === 'number' && list(record, 'g').includes(74);
        const also = diameter ? h('span', {}, `Ø ${(2 * value).toFixed(3)}`) : null;
        return h('span', { class: moved.has(letter) ? 'cell moved' : 'cell' }, h('b', {}, letter), text, also);
      });
    return this.#section('position', h('div', { class: 'cells' }, ...cells));
  }

  /** A block by its number, for taking it in hand. */
  #link(index: number): HTMLElement {
    const { program } = this.#app;
    const { seq, file, line, block } = this.#app.place(index);
    const title = `seq ${seq}, ${this.#app.header.files[file]!.name}:${line}`;
    return h(
      'button',
      { type: 'button', class: 'link', title, onclick: () => this.#app.select(index) },
      `N${program.n[block]!}`,
    );
  }

  #functions(_: Fields, key: Key, letter: string, values: (number | null)[], written: Set<number>): HTMLElement {
    const inForce = values.filter((value) => value !== null);
    const names = new Set(inForce.map((value) => `${letter}${value}`));
    const writers = this.#app.history.writers(this.#app.current!, names);
    const cells = inForce.map((value) => {
      const writer = writers.get(`${letter}${value}`);
      const by =
        writer === undefined
          ? t('powerUp')
          : `${t('writtenBy')} N${this.#app.program.n[this.#app.place(writer).block]!}`;
      const name = `${letter}${two(value)}`;
      const attributes = { class: written.has(value) ? 'chip written' : 'chip', title: by };
      return writer === undefined
        ? h('span', attributes, name)
        : h('button', { ...attributes, type: 'button', onclick: () => this.#app.select(writer) }, name);
    });
    return this.#section(key, h('div', { class: 'chips' }, ...cells));
  }

  #words(record: Fields): HTMLElement | null {
    const rows: [string, string][] = [];
    if (typeof record['feed'] === 'number') {
      const scale = typeof record['feed_scale'] === 'number' ? ` × ${record['feed_scale']}` : '';
      rows.push(['F', `${shown(record['feed'])} ${String(record['feed_unit'] ?? '')}${scale}`]);
    }
    for (const [name, field] of [
      ['S', 's'],
      ['T', 't'],
      ['T (M06)', 'tool'],
      ['D', 'd'],
      ['H', 'h'],
      ['P', 'p'],
      ['&', 'length_correction'],
      ['I (G23)', 'dynamic_set'],
    ] as const) {
      if (record[field] !== undefined) {
        rows.push([name, String(record[field])]);
      }
    }
    return rows.length === 0 ? null : this.#section('words', this.#rows(rows));
  }

  #motion(record: Fields): HTMLElement | null {
    const motion = at(record, 'motion');
    const type = motion['type'];
    if (typeof type !== 'string') {
      return null;
    }
    const rows: [string, string][] = [['', t(type as Key)]];
    for (const [field, key, unit] of [
      ['length_mm', 'length', 'mm'],
      ['length_deg', 'length', '°'],
      ['radius_mm', 'radius', 'mm'],
      ['sweep_deg', 'sweep', '°'],
    ] as const) {
      const value = motion[field];
      if (typeof value === 'number') {
        rows.push([t(key), `${shown(value)} ${unit}`]);
      }
    }
    return this.#section('mapped', this.#rows(rows));
  }

  #velocity(record: Fields): HTMLElement | null {
    if (typeof record['start_s'] !== 'number' && record['joint'] === undefined) {
      return null;
    }
    const rows: [string, string][] = [];
    const number = (key: Key, field: string, unit: string, decimals = 1): void => {
      const value = record[field];
      if (typeof value === 'number') {
        rows.push([t(key), `${shown(value, decimals)} ${unit}`]);
      }
    };
    if (typeof record['start_s'] === 'number') {
      rows.push([t('start'), clock(record['start_s'])]);
    }
    const { program, times } = this.#app;
    const index = this.#app.current!;
    if (typeof record['duration_s'] === 'number') {
      const more = times?.isUnknown(index) === true;
      rows.push([t('duration'), least(`${shown(record['duration_s'], 3)} s`, more)]);
    }
    const unit = program.feedUnit(program.rowOf(index));
    number('programmed', 'programmed', unit);
    if (typeof record['cap'] === 'number') {
      rows.push([t('cap'), `${shown(record['cap'], 1)} ${unit} (${named(String(record['cap_by']))})`]);
    }
    number('atStart', 'start', unit);
    number('peak', 'peak', unit);
    number('atEnd', 'end', unit);
    const section = this.#section('times', this.#rows(rows));
    const joint = at(record, 'joint');
    if (record['joint'] !== undefined) {
      const parts: [string, string][] = [];
      const broken = joint['broken_by'];
      const limited = joint['limited_by'];
      parts.push(['', typeof broken === 'string' ? `${t('broken')}: ${named(broken)}` : t('continuous')]);
      if (typeof joint['angle_deg'] === 'number') {
        parts.push([t('angle'), `${shown(joint['angle_deg'], 2)}°`]);
      }
      if (typeof joint['feed'] === 'number') {
        parts.push([t('velocities'), `${shown(joint['feed'], 1)} ${unit}`]);
      }
      const cap = times?.jointCap(index);
      if (cap !== undefined && joint['broken_by'] === undefined) {
        parts.push([t('cap'), `${shown(cap, 1)} ${unit}`]);
      }
      if (typeof limited === 'string') {
        parts.push([t('limit'), named(limited)]);
      }
      if (joint['dot'] === 'red' || joint['dot'] === 'yellow') {
        parts.push([t('dot'), t(joint['dot'])]);
      }
      section.append(h('h2', {}, t('joint')), this.#rows(parts));
    }
    return section;
  }

  /** The parameters that the program has written so far. */
  #parameters(): HTMLElement | null {
    const found = this.#app.history.parameters(this.#app.current!);
    const rows = found.flatMap(([name, value, index]) => [
      h('dt', {}, name),
      h('dd', {}, `${value} `, this.#link(index)),
    ]);
    return rows.length === 0 ? null : this.#section('parameters', h('dl', {}, ...rows));
  }

  /** What is left, and what comes next. */
  #ahead(): HTMLElement | null {
    const { header, history, program, times } = this.#app;
    const { start_s, total } = header;
    const index = this.#app.current!;
    const rows: [Key, string | HTMLElement][] = [['blocksLeft', local(header.blocks - program.from - index - 1, 0)]];
    const whole = total?.['time_s'];
    if (times !== undefined && typeof whole === 'number') {
      const left = whole - start_s - times.startOf(index) - times.durationOf(index);
      rows.push(['timeLeft', least(clock(Math.max(left, 0)), total?.['at_least'] === true)]);
    }
    const { tool, stop, rapid } = history.ahead(index);
    for (const [key, next] of [
      ['nextTool', tool],
      ['nextStop', stop],
      ['nextRapid', rapid],
    ] as const) {
      if (next !== undefined) {
        rows.push([key, this.#link(next)]);
      }
    }
    const items = rows.flatMap(([key, value]) => [h('dt', {}, t(key)), h('dd', {}, value)]);
    return this.#section('ahead', h('dl', {}, ...items));
  }

  /** The command that writes a program which starts here. Standard input can be read only once. */
  #restart(record: Fields): HTMLElement | null {
    const { program, arguments: given = [] } = this.#app.header;
    if (program.name === '-') {
      return null;
    }
    const file = program.name.startsWith('-') ? `./${program.name}` : program.name;
    const command = ['cnc872c', 'restart', file, '--seq', String(record['seq']), ...given].map(quoted).join(' ');
    const code = h('code', {}, command);
    const copied = h('span', { role: 'status' });
    // A page from a file may have no clipboard: then the command is selected.
    const copy = async (): Promise<void> => {
      try {
        await navigator.clipboard.writeText(command);
        copied.textContent = t('copied');
      } catch {
        getSelection()?.selectAllChildren(code);
        copied.textContent = t('selected');
      }
    };
    const copies = h('button', { type: 'button', 'data-focus': 'copy', onclick: () => void copy() }, t('copy'));
    const told = h(
      'div',
      { class: 'command', hidden: !this.#starts },
      h('p', {}, t('restartHow')),
      code,
      copies,
      ' ',
      copied,
    );
    const toggle = (): void => {
      this.#starts = !this.#starts;
      told.hidden = !this.#starts;
      button.setAttribute('aria-expanded', String(this.#starts));
    };
    const button = h(
      'button',
      { type: 'button', 'data-focus': 'restart', 'aria-expanded': String(this.#starts), onclick: toggle },
      t('restart'),
    );
    return h('section', { class: 'restart' }, button, told);
  }
}

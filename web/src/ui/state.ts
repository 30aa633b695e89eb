// What holds at the block in hand, and how execution came to it.

import type { App } from '../app.ts';
import type { Fields } from '../data/header.ts';
import type { Writers } from '../data/history.ts';
import { quoted } from '../data/shell.ts';
import { type Key, named, t } from '../i18n.ts';
import { clock, h, idle, least, local, rebuild, shown } from './dom.ts';

/** The record of an executed block with that of its motion: one flat object. */
export function currentRecord(app: App): Fields | null {
  if (app.current === null) {
    return null;
  }
  const { program } = app;
  const block = program.block[program.rowOf(app.current)]!;
  const passes = program.executionsOf(block).filter((index) => index !== app.current);
  return { ...recordOf(app, app.current), passes: passes.map((index) => program.from + index) };
}

function recordOf({ program, times }: App, index: number): Fields {
  return { ...program.record(index), ...times?.record(index) };
}

/** The values beside functions, by the names of records and of `cnc872c state`; whether those not programmed are told. */
const VALUES: readonly [name: string, field: string, always: boolean][] = [
  ['F', 'feed', true],
  ['S', 's', true],
  ['gear', 'gear', false],
  ['T', 't', true],
  ['T (M06)', 'tool', true],
  ['D', 'd', false],
  ['H', 'h', false],
  ['P', 'p', false],
  ['&', 'length_correction', false],
  ['I (G23)', 'dynamic_set', false],
];

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
    const { current } = this.#app;
    if (current === null) {
      rebuild(this.element, h('p', { class: 'empty' }, t('noBlock')));
      return;
    }
    const record = recordOf(this.#app, current);
    const writers = this.#app.history.writers(current);
    const parts = [
      this.#head(record),
      this.#position(record, writers),
      this.#functions('gGroups', 'G', this.#app.program.heldBehind(current), list(record, 'g_set'), writers),
      this.#functions('mGroups', 'M', list(record, 'm'), list(record, 'm_set'), writers),
      this.#words(record, writers),
      this.#motion(record),
      this.#velocity(record),
      this.#parameters(writers),
      this.#counters(),
      this.#progress(writers),
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
    const { before, all } = this.#app.program.passOf(this.#app.current!);
    if (all > 1) {
      const text = t('executionOf', { i: before + 1, n: all });
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
              ...idle(before === all - 1),
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

  #position(record: Fields, writers: Writers): HTMLElement {
    const { header, history, program } = this.#app;
    const index = this.#app.current!;
    const position = at(record, 'position');
    const moved = new Set((at(record, 'motion')['axes'] ?? []) as string[]);
    const why = program.shapeOf(program.rowOf(index)).w ?? {};
    const axes = header.program.axes.filter(({ letter }) => letter in position || history.moves(letter));
    const cells = axes.map(({ letter, kind }) => {
      const value = position[letter];
      // At a call of the machine's macrocycle the record says where the axes stand before it.
      const known = typeof value === 'number' && why[letter] === undefined;
      const text = known
        ? `${value.toFixed(3)}${kind === 'rotary' ? '°' : ''}`
        : `${t('unknown')}: ${t(`unknown_${why[letter] ?? 'not_programmed'}` as Key)}`;
      // Positions are radii, also where X is programmed as a diameter.
      const diameter = letter === 'X' && known && program.heldBehind(index).includes(74);
      const also = diameter ? h('span', {}, `Ø ${(2 * value).toFixed(3)}`) : null;
      const attributes = { class: moved.has(letter) ? 'cell moved' : 'cell', 'data-focus': letter };
      return this.#writtenBy(known ? writers(letter) : undefined, known, attributes, h('b', {}, letter), text, also);
    });
    return this.#section('position', h('div', { class: 'cells' }, ...cells));
  }

  /** What a block wrote: leads to the block, and names it. */
  #writtenBy(
    writer: number | undefined,
    holds: boolean,
    attributes: Record<string, string>,
    ...children: (Node | string | null)[]
  ): HTMLElement {
    if (writer !== undefined) {
      const title = `${t('writtenBy')} N${this.#app.program.n[this.#app.place(writer).block]!} (${this.#named(writer)})`;
      const onclick = (): void => this.#app.select(writer);
      return h('button', { ...attributes, title, type: 'button', onclick }, ...children);
    }
    // What blocks before the page wrote, nobody tells.
    const title = holds && this.#app.program.from === 0 ? t('powerUp') : undefined;
    return h('span', { ...attributes, title }, ...children);
  }

  /** The place of an executed block. */
  #named(index: number): string {
    const { seq, file, line } = this.#app.place(index);
    return `seq ${seq}, ${this.#app.header.files[file]!.name}:${line}`;
  }

  /** A block by its number, for taking it in hand; `focus`: the name of the control. */
  #link(index: number, focus: string): HTMLElement {
    const onclick = (): void => this.#app.select(index);
    const attributes = { type: 'button', class: 'link', title: this.#named(index), 'data-focus': focus, onclick };
    return h('button', attributes, `N${this.#app.program.n[this.#app.place(index).block]!}`);
  }

  /** The functions in force by group, then those that the block has for itself alone. */
  #functions(key: Key, letter: 'G' | 'M', values: (number | null)[], written: number[], writers: Writers): HTMLElement {
    const index = this.#app.current!;
    const slot = (group: number): string => `${letter.toLowerCase()}${group}`;
    const inForce = values.flatMap((value, group) => (value === null ? [] : [{ value, group }]));
    const cells = inForce.map(({ value, group }) => {
      const writer = writers(slot(group));
      const isOwn = writer === index || written.includes(value);
      const attributes = { class: isOwn ? 'chip written' : 'chip', 'data-focus': slot(group) };
      return this.#writtenBy(isOwn ? index : writer, true, attributes, `${letter}${two(value)}`);
    });
    const own = written.filter((code) => !values.includes(code));
    cells.push(...own.map((code) => h('span', { class: 'chip written' }, `${letter}${two(code)}`)));
    return this.#section(key, h('div', { class: 'chips' }, ...cells));
  }

  #words(record: Fields, writers: Writers): HTMLElement {
    const value = (field: string): string | undefined => {
      const known = record[field];
      if (known === undefined) {
        return undefined;
      }
      if (field !== 'feed') {
        return String(known);
      }
      const scale = typeof record['feed_scale'] === 'number' ? ` × ${record['feed_scale']}` : '';
      return `${shown(Number(known))} ${String(record['feed_unit'] ?? '')}${scale}`;
    };
    const rows = VALUES.flatMap(([name, field, always]) => {
      const [known, writer] = [value(field), writers(field)];
      // The set of motions in G00 is not the one that a block chose.
      if (known === undefined && (field === 'dynamic_set' || (!always && writer === undefined))) {
        return [];
      }
      const nothing = writer === undefined ? t('unknown_not_programmed') : t('unknownHere');
      return [
        h('dt', {}, field === 'gear' ? t('gear') : name),
        h('dd', {}, `${known ?? nothing} `, writer === undefined ? null : this.#link(writer, field)),
      ];
    });
    return this.#section('words', h('dl', {}, ...rows));
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

  /** The parameters that the machine had, or the program has written so far. */
  #parameters(writers: Writers): HTMLElement | null {
    const rows = this.#app.history
      .parameters(writers)
      .flatMap(([name, value, writer]) => [
        h('dt', {}, name),
        h('dd', {}, `${value} `, writer === undefined ? null : this.#link(writer, name)),
      ]);
    return rows.length === 0 ? null : this.#section('parameters', h('dl', {}, ...rows));
  }

  /** The counters of jumps that are armed. */
  #counters(): HTMLElement | null {
    const rows = this.#app.history
      .counters(this.#app.current!)
      .flatMap(({ index, left, of }, place) => [
        h('dt', {}, this.#link(index, `counter ${place}`)),
        h('dd', {}, of === undefined ? t('counterLeft', { left }) : t('counter', { left, of })),
      ]);
    return rows.length === 0 ? null : this.#section('counters', h('dl', {}, ...rows));
  }

  /** What is done and what is left, in all and for the tool in the spindle, and what comes next. */
  #progress(writers: Writers): HTMLElement {
    const { header, history, program, times } = this.#app;
    const { start_s, total } = header;
    const behind = this.#app.current! + 1;
    const whole = Number(total?.['time_s'] ?? 0);
    const more = total?.['at_least'] === true || total?.['without_approach'] === true || !header.whole;
    // Name, how much comes before a block, how much there is, and how that is said.
    const quantities: [Key, (index: number) => number, number, (value: number) => string][] = [
      ['blocksDone', (index) => program.from + index, header.blocks, (value) => local(value, 0)],
      ['pathDone', (index) => history.pathBefore(index), history.path, (value) => `${shown(value)} mm`],
    ];
    if (times !== undefined) {
      quantities.push(['timeDone', (index) => start_s + times.startOf(index), whole, clock]);
    }
    const { tool, stop, rapid } = history.ahead(behind - 1);
    const change = writers('tool') ?? 0;
    const row = (name: string, done: number, left: number, say: (value: number) => string): HTMLElement =>
      h(
        'tr',
        {},
        h('th', { scope: 'row' }, name),
        ...[done, left].map((value) => h('td', {}, say(Math.max(value, 0)))),
      );
    const rows = quantities.map(([key, before, end, say]) => row(t(key), before(behind), end - before(behind), say));
    if (history.changesTools && program.isWhole) {
      rows.push(h('tr', {}, h('th', { colspan: 3, scope: 'rowgroup' }, t('thisTool'))));
      for (const [key, before, end, say] of quantities) {
        const until = tool === undefined ? end : before(tool);
        rows.push(row(t(key), before(behind) - before(change), until - before(behind), say));
      }
    }
    const names = [t('done'), t('left')].map((name) => h('th', { scope: 'col' }, name));
    const head = h('thead', {}, h('tr', {}, h('td'), ...names));
    const table = h('table', { class: 'progress' }, head, h('tbody', {}, ...rows));
    const next = (
      [
        ['nextTool', tool],
        ['nextStop', stop],
        ['nextRapid', rapid],
      ] as const
    ).flatMap(([key, index]) =>
      index === undefined ? [] : [h('dt', {}, t(key)), h('dd', {}, this.#link(index, key))],
    );
    const note = more ? h('p', { class: 'cut' }, t('progressAtLeast')) : '';
    return this.#section('progress', table, note, h('dl', {}, ...next));
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

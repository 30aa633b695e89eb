// The text of the program, line by line: only what is in sight is in the page, unless the file is short.

import type { App } from '../app.ts';
import { h, labelled } from './dom.ts';

/** Files of up to so many lines stand in the page as a whole. */
const SHORT = 2500;
/** Height of a line, in CSS pixels; the sheet of styles has the same. */
const LINE = 18;
/** No browser scrolls further than this. */
const TALLEST = 8_000_000;

/** What words are, for their colours. */
const WORD =
  /("[^"]*"?)|(N\s*\d*)|([GML]\s*[-+]?\d*)|([XYZABCUVWIJK]\s*=?\s*[-+]?(?:\d*\.?\d*|R\d+))|([FSTHPDQ]\s*=?\s*[-+]?(?:\d*\.?\d*|R\d+))|(R\s*\d+(?:\s*=?\s*[-+]?[\d.]+)?)|(%\s*\d*|\*|\/)/gi;
const CLASSES = ['comment', 'number', 'function', 'axis', 'word', 'parameter', 'frame'];

export class Code {
  readonly element: HTMLElement;
  readonly #app: App;
  readonly #files: HTMLSelectElement;
  readonly #scroll: HTMLElement;
  readonly #lines: HTMLElement;
  #file = 0;
  #first = -1;
  #last = -1;
  #marked: { file: number; line: number } | undefined;

  constructor(app: App) {
    this.#app = app;
    this.#files = labelled(h('select'), 'file');
    this.#lines = h('div', { class: 'lines' });
    this.#scroll = labelled(h('div', { class: 'code', tabindex: 0, role: 'region' }, this.#lines), 'text');
    this.element = h('section', { class: 'text' }, h('div', { class: 'bar' }, this.#files), this.#scroll);
    this.#files.addEventListener('change', () => this.#open(Number(this.#files.value)));
    this.#scroll.addEventListener('scroll', () => this.#fill());
    new ResizeObserver(() => this.#fill()).observe(this.#scroll);
    this.#lines.addEventListener('click', (event) => this.#clicked(event.target as HTMLElement));
    this.#scroll.addEventListener('keydown', (event) => this.#key(event));
    app.on('select', () => this.#follow());
    app.on('data', () => this.#load());
    this.#load();
  }

  #load(): void {
    const { files } = this.#app.header;
    this.#files.replaceChildren(...files.map((file, index) => h('option', { value: index }, file.name)));
    this.#files.hidden = files.length < 2;
    this.#open(Math.min(this.#file, Math.max(files.length - 1, 0)));
  }

  get #count(): number {
    return this.#app.text.lines[this.#file] ?? 0;
  }

  /** Very long files scroll more than a line by a line. */
  get #height(): number {
    return Math.min(LINE, TALLEST / Math.max(this.#count, 1));
  }

  #open(file: number): void {
    this.#file = file;
    this.#files.value = String(file);
    this.#first = -1;
    this.#last = -1;
    this.#lines.replaceChildren();
    this.#lines.style.height = `${this.#count * this.#height}px`;
    this.#lines.style.setProperty('--digits', `${String(this.#count).length}ch`);
    this.#fill();
  }

  #fill(): void {
    const count = this.#count;
    let [first, last] = [1, count];
    const height = this.#height;
    if (count > SHORT) {
      const rows = Math.ceil(this.#scroll.clientHeight / LINE) + 40;
      first = Math.max(Math.floor(this.#scroll.scrollTop / height) - 20, 1);
      last = Math.min(first + rows, count);
      if (first >= this.#first && last <= this.#last) {
        return;
      }
    } else if (this.#first === 1 && this.#last === last) {
      return;
    }
    [this.#first, this.#last] = [first, last];
    const lines: HTMLElement[] = [];
    for (let line = first; line <= last; line += 1) {
      lines.push(this.#line(line));
    }
    this.#lines.replaceChildren(...lines);
    this.#lines.style.paddingTop =
      count > SHORT ? `${Math.min((first - 1) * height, count * height - (last - first + 1) * LINE)}px` : '0';
    this.#mark();
  }

  #line(line: number): HTMLElement {
    const { program, text } = this.#app;
    const row = h('div', { class: 'line', 'data-no': line });
    for (const piece of text.line(this.#file, line)) {
      const span = h('span');
      if (piece.block >= 0) {
        span.dataset['file'] = String(this.#file);
        span.dataset['line'] = String(program.line[piece.block]!);
        span.dataset['block'] = String(piece.block);
        span.className = 'block';
      }
      let at = 0;
      for (const match of piece.text.matchAll(WORD)) {
        if (match.index > at) {
          span.append(piece.text.slice(at, match.index));
        }
        const kind = match.slice(1).findIndex((part) => part !== undefined);
        span.append(h('b', { class: CLASSES[kind] }, match[0]));
        at = match.index + match[0].length;
      }
      span.append(piece.text.slice(at));
      row.append(span);
    }
    return row;
  }

  #clicked(target: HTMLElement): void {
    const span = target.closest<HTMLElement>('[data-block]');
    if (span === null) {
      return;
    }
    const executions = this.#app.program.executionsOf(Number(span.dataset['block']));
    this.#choose(executions);
  }

  /** Takes the first execution; when one of them is in hand, the next. */
  #choose(executions: number[]): void {
    if (executions.length === 0) {
      return;
    }
    const at = this.#app.current === null ? -1 : executions.indexOf(this.#app.current);
    this.#app.select(executions[(at + 1) % executions.length]!);
    this.#app.gather();
  }

  #key(event: KeyboardEvent): void {
    if (event.key !== 'ArrowDown' && event.key !== 'ArrowUp') {
      return;
    }
    event.preventDefault();
    const { program, current } = this.#app;
    const from = current === null ? undefined : this.#app.place(current);
    const block = from === undefined || from.file !== this.#file ? program.firstBlock[this.#file]! : from.block;
    const by = event.key === 'ArrowDown' ? 1 : -1;
    for (
      let next = from === undefined ? block : block + by;
      next >= program.firstBlock[this.#file]! && next < program.firstBlock[this.#file + 1]!;
      next += by
    ) {
      const executions = program.executionsOf(next);
      if (executions.length > 0 && !executions.includes(current ?? -1)) {
        this.#app.select(executions[0]!);
        this.#app.gather();
        return;
      }
    }
  }

  #follow(): void {
    const { current } = this.#app;
    if (current === null) {
      this.#marked = undefined;
      this.#mark();
      return;
    }
    const { file, line } = this.#app.place(current);
    this.#marked = { file, line };
    if (file !== this.#file) {
      this.#open(file);
    }
    const height = this.#height;
    const top = (line - 1) * height;
    const { scrollTop, clientHeight } = this.#scroll;
    if (top < scrollTop + 2 * LINE || top > scrollTop + clientHeight - 3 * LINE) {
      this.#scroll.scrollTop = top - clientHeight / 3;
      this.#fill();
    }
    this.#mark();
  }

  #mark(): void {
    for (const element of this.#lines.querySelectorAll('.current')) {
      element.classList.remove('current');
      element.removeAttribute('aria-current');
    }
    if (this.#marked !== undefined && this.#marked.file === this.#file) {
      for (const element of this.#lines.querySelectorAll(`[data-line="${this.#marked.line}"]`)) {
        element.classList.add('current');
        element.setAttribute('aria-current', 'true');
      }
    }
  }
}

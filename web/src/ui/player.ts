// Time: the slider, playing, steps, stops.

import type { App } from '../app.ts';
import { type Key, t } from '../i18n.ts';
import type { View } from '../scene/view.ts';
import { clock, h, labelled, said } from './dom.ts';

const SPEEDS = [1, 2, 5, 10, 20, 50, 100];
/** Without times every block takes so long, in seconds. */
const BLOCK = 0.25;

export class Player {
  readonly element: HTMLElement;
  readonly #app: App;
  readonly #view: View;
  readonly #slider: HTMLInputElement;
  readonly #clock: HTMLElement;
  readonly #button: HTMLButtonElement;
  readonly #speeds: HTMLSelectElement;
  readonly #stops = { red: false, m00: false, m01: false, tool: false };
  #frame = 0;
  #time = 0;
  #last = 0;
  #speed = 1;

  constructor(app: App, view: View) {
    this.#app = app;
    this.#view = view;
    this.#slider = labelled(h('input', { type: 'range', min: 0, max: 1000, step: 'any', class: 'slider' }), 'slider');
    this.#clock = h('span', { class: 'clock' });
    this.#button = h('button', { type: 'button', class: 'play', onclick: () => this.toggle() });
    this.#speeds = labelled(h('select'), 'speed');
    this.#speeds.append(...SPEEDS.map((speed) => h('option', { value: speed }, `${speed}×`)));
    this.#speeds.addEventListener('change', () => {
      this.#speed = Number(this.#speeds.value);
    });
    const step = (key: Key, by: number, sign: string): HTMLElement =>
      labelled(h('button', { type: 'button', onclick: () => app.step(by) }, sign), key);
    const stops = (['red', 'm00', 'm01', 'tool'] as const).map((what) => {
      const box = h('input', { type: 'checkbox' });
      box.addEventListener('change', () => {
        this.#stops[what] = box.checked;
      });
      const keys = { red: 'stopRed', m00: 'stopM00', m01: 'stopM01', tool: 'stopTool' } as const;
      return h('label', {}, box, said('span', keys[what]));
    });
    this.#slider.addEventListener('input', () => {
      this.stop();
      this.#seek(Number(this.#slider.value));
    });
    this.element = labelled(
      h(
        'section',
        { class: 'player' },
        step('previous', -1, '‹'),
        this.#button,
        step('next', 1, '›'),
        this.#speeds,
        this.#slider,
        this.#clock,
        h('span', { class: 'stops' }, said('span', 'stopAt'), ...stops),
      ),
      'playback',
    );
    app.on('select', ({ by }) => {
      if (by !== 'play') {
        this.stop();
        this.#time = app.current === null ? 0 : this.#startOf(app.current);
        view.share = undefined;
      }
      this.#tell();
    });
    app.on('data', () => {
      this.stop();
      this.#load();
    });
    app.on('language', () => this.#tell());
    this.#load();
  }

  #load(): void {
    this.#slider.max = String(this.#total);
    this.#time = 0;
    this.#tell();
  }

  get #total(): number {
    return this.#app.times?.total ?? this.#app.program.count * BLOCK;
  }

  #startOf(index: number): number {
    return this.#app.times?.startOf(index) ?? index * BLOCK;
  }

  #durationOf(index: number): number {
    return this.#app.times?.durationOf(index) ?? BLOCK;
  }

  #at(time: number): number {
    const { times, program } = this.#app;
    const index = times === undefined ? Math.floor(time / BLOCK) : times.at(time);
    return Math.min(Math.max(index, 0), program.count - 1);
  }

  #seek(time: number): void {
    if (this.#app.program.count === 0) {
      return;
    }
    this.#time = time;
    const index = this.#at(time);
    this.#place(index);
    this.#app.select(index, 'play');
    this.#view.request('held');
    this.#tell();
  }

  #place(index: number): void {
    const duration = this.#durationOf(index);
    const share = duration > 0 ? Math.min(Math.max((this.#time - this.#startOf(index)) / duration, 0), 1) : 1;
    this.#view.share = this.#app.times?.wayAt(index, share) ?? share;
  }

  get playing(): boolean {
    return this.#frame !== 0;
  }

  toggle(): void {
    if (this.playing) {
      this.stop();
    } else {
      this.play(this.#speed);
    }
  }

  /** Plays on from the block in hand, so many times as fast as the machine. */
  play(speed: number): void {
    const { program, current } = this.#app;
    if (program.count === 0) {
      return;
    }
    this.#speed = speed;
    if (SPEEDS.includes(speed)) {
      this.#speeds.value = String(speed);
    }
    // From the end it begins anew.
    if (current === null || (current >= program.count - 1 && this.#time >= this.#total)) {
      this.#time = 0;
      this.#app.select(0, 'play');
    }
    this.#last = performance.now();
    cancelAnimationFrame(this.#frame);
    this.#frame = requestAnimationFrame(() => this.#tick());
    this.#tell();
  }

  stop(): void {
    if (this.playing) {
      cancelAnimationFrame(this.#frame);
      this.#frame = 0;
      this.#tell();
    }
  }

  #tick(): void {
    const now = performance.now();
    const before = this.#app.current ?? 0;
    let time = this.#time + ((now - this.#last) / 1000) * this.#speed;
    this.#last = now;
    let index = Math.max(time >= this.#total ? this.#app.program.count - 1 : this.#at(time), before);
    const stop = this.#stopBetween(before, index);
    if (stop !== undefined) {
      index = stop.index;
      time = stop.time;
    }
    this.#time = Math.min(time, this.#total);
    this.#place(index);
    const ended = stop !== undefined || time >= this.#total;
    this.#frame = ended ? 0 : requestAnimationFrame(() => this.#tick());
    this.#app.select(index, 'play');
    this.#view.request('held');
    this.#tell();
  }

  /** The first place to stop at, from the block behind `before` up to `index`. */
  #stopBetween(before: number, index: number): { index: number; time: number } | undefined {
    const { red, m00, m01, tool } = this.#stops;
    if (!red && !m00 && !m01 && !tool) {
      return undefined;
    }
    const { program, times } = this.#app;
    const { extras } = program.header;
    for (let next = before + 1; next <= index; next += 1) {
      const extra = extras[program.extra[program.rowOf(next)]!]!;
      const written = (extra['m_set'] ?? []) as number[];
      const stops =
        (red && times?.dotOf(next) === 'red') ||
        (m00 && extra['stop'] === true) ||
        (m01 && extra['cond_stop'] === true) ||
        (tool && written.includes(6));
      if (stops) {
        return { index: next, time: this.#startOf(next) };
      }
    }
    return undefined;
  }

  #tell(): void {
    this.#slider.value = String(this.#time);
    const label = t(this.playing ? 'pause' : 'play');
    this.#button.textContent = this.playing ? '❚❚' : '►';
    this.#button.setAttribute('aria-label', label);
    this.#button.title = label;
    const text = this.#app.times === undefined ? '' : `${clock(this.#time)} / ${clock(this.#total)}`;
    this.#clock.textContent = text;
    this.#slider.setAttribute('aria-valuetext', text === '' ? `${this.#app.current ?? 0}` : text);
  }
}

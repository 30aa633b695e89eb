// Velocity over time or over blocks, by uPlot.

import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';

import type { App } from '../app.ts';
import { type Key, t } from '../i18n.ts';
import { css, type Theme } from '../scene/colours.ts';
import type { View } from '../scene/view.ts';
import { clock, h, labelled, local, said, shown } from './dom.ts';

/** Above so many blocks in sight, columns of pixels show the least and the greatest of theirs. */
const POINTS = 3000;
/** Caps of joints are drawn while there are no more blocks than so many in sight. */
const CAPS = 400;
/** Lines between blocks are drawn while there are no more than so many in sight. */
const LINES = 160;

/** Steps between times on the axis, in seconds, and between blocks. */
const SECONDS = [
  0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200,
  14_400, 36_000, 86_400, 360_000,
];
const COUNTS = [1, 2, 5]
  .flatMap((lead) => Array.from({ length: 8 }, (_, power) => lead * 10 ** power))
  .sort((a, b) => a - b);
const LABEL = '11px system-ui, sans-serif';

/** A time on the axis: h:mm:ss, with as many decimals as the step has. */
export function tickTime(seconds: number, step: number): string {
  const decimals = step >= 1 ? 0 : step >= 0.1 ? 1 : step >= 0.01 ? 2 : 3;
  const parts = Math.round(seconds * 10 ** decimals);
  const whole = Math.floor(parts / 10 ** decimals);
  const two = (value: number): string => String(value).padStart(2, '0');
  const rest = decimals === 0 ? '' : `.${String(parts % 10 ** decimals).padStart(decimals, '0')}`;
  return `${Math.floor(whole / 3600)}:${two(Math.floor(whole / 60) % 60)}:${two(whole % 60)}${rest}`;
}

/** The programmed feed is told from the grid. */
const PROGRAMMED = (theme: Theme): number => theme.kinds[0]!;

type Data = [number[], (number | null)[], (number | null)[], (number | null)[]];

export class Chart {
  readonly element: HTMLElement;
  readonly #app: App;
  readonly #view: View;
  readonly #plotPlace = h('div', { class: 'plot' });
  readonly #facts = h('p', { class: 'facts' });
  /** What the lines are. */
  readonly #signs = h('ul', { class: 'signs' });
  readonly #by = labelled(h('select'), 'chart');
  #plot: uPlot | undefined;
  /** What is in sight: seconds or indices. */
  #range: [number, number] = [0, 1];
  #overTime = true;
  /** Whether the scale has room for rapid motions. */
  #rapids = false;
  /** The scale: the fastest in sight that is shown whole, and the fastest of all. */
  #top = 1;
  #fastest = 1;
  readonly #cut = h('span', { class: 'cut', role: 'status' });

  constructor(app: App, view: View) {
    this.#app = app;
    this.#view = view;
    this.#by.append(said('option', 'overTime', { value: 'time' }), said('option', 'overBlocks', { value: 'blocks' }));
    this.#by.addEventListener('change', () => {
      this.#overTime = this.#by.value === 'time';
      this.#whole();
    });
    const head = h(
      'div',
      { class: 'bar' },
      said('h2', 'chart'),
      this.#by,
      said('button', 'wholeChart', { type: 'button', onclick: () => this.#whole() }),
      said('button', 'chartCurrent', { type: 'button', onclick: () => this.#near() }),
      h('label', {}, this.#box(), said('span', 'showRapids')),
      this.#cut,
      this.#facts,
      this.#signs,
    );
    this.#plotPlace.setAttribute('role', 'application');
    this.#plotPlace.tabIndex = 0;
    this.#plotPlace.addEventListener('keydown', (event) => this.#key(event));
    labelled(this.#plotPlace, 'chartLabel');
    this.element = h('section', { class: 'chart' }, head, this.#plotPlace);
    app.on('data', () => this.#load());
    app.on('theme', () => this.#load());
    app.on('language', () => {
      this.#explain();
      this.#tell();
      if (app.times !== undefined) {
        this.#zoom(...this.#range);
      }
    });
    app.on('select', () => this.#tell());
    new ResizeObserver(() => this.#resize()).observe(this.#plotPlace);
    this.#load();
  }

  #load(): void {
    this.#plot?.destroy();
    this.#plot = undefined;
    this.element.hidden = this.#app.times === undefined;
    if (this.#app.times !== undefined) {
      this.#range = [0, this.#end];
      this.#resize();
    }
    this.#explain();
    this.#tell();
  }

  #box(): HTMLElement {
    const box = h('input', { type: 'checkbox' });
    box.addEventListener('change', () => {
      this.#rapids = box.checked;
      this.#zoom(...this.#range);
    });
    return box;
  }

  /** The scale is that of working motions in sight, unless rapid ones are wanted or alone. */
  #scale(first: number, last: number): void {
    const { path, program, times } = this.#app;
    let [working, all] = [0, 0];
    for (let index = first; index <= last; index += 1) {
      const row = program.rowOf(index);
      const peak = times!.peakOf(index);
      all = Math.max(all, peak);
      if (program.shapeOf(row).m !== undefined && program.shapeOf(row).m!['type'] !== 'rapid') {
        const programmed = path.hasLine(row) ? (times!.velocities(index)?.programmed ?? 0) : 0;
        working = Math.max(working, peak, programmed);
      }
    }
    this.#fastest = all;
    this.#top = this.#rapids || working === 0 ? Math.max(all, working) : working;
    this.#cut.textContent = this.#fastest > this.#top * 1.06 ? t('cutOff') : '';
  }

  /** Says what the lines are. */
  #explain(): void {
    const { theme } = this.#view;
    const { header, program } = this.#app;
    const sign = (key: Key, kind: string, colour: string): HTMLElement => {
      const mark = h('span', { class: `sign ${kind}` });
      mark.style.setProperty('--colour', colour);
      return h('li', { class: 'item' }, mark, t(key));
    };
    const turns = header.shapes.some((_, shape) => program.turnsBy(shape));
    this.#signs.replaceChildren(
      sign('keyVelocity', 'solid', css(theme.velocity)),
      sign('keyProgrammed', 'dashed', css(PROGRAMMED(theme))),
      sign('keyCap', 'dotted', css(theme.kinds[2]!)),
      sign('keyJointCap', 'tick', css(theme.kinds[3]!)),
      sign('keyJoints', 'joint', css(theme.red)),
      sign('keyBlocks', 'between', css(theme.gridStrong)),
      ...(turns ? [h('li', { class: 'item' }, t('keyTurning'))] : []),
    );
  }

  get #end(): number {
    const { times, program } = this.#app;
    return Math.max(this.#overTime ? times!.total : program.count, 1e-6);
  }

  #whole(): void {
    this.#zoom(0, this.#end);
  }

  /** Some blocks about the one in hand. */
  #near(): void {
    const { current, program, times } = this.#app;
    const at = current ?? 0;
    const [from, to] = [Math.max(at - 12, 0), Math.min(at + 13, program.count - 1)];
    this.#zoom(this.#overTime ? times!.startOf(from) : from, this.#overTime ? times!.startOf(to) : to);
  }

  #zoom(from: number, to: number): void {
    const end = this.#end;
    const span = Math.min(Math.max(to - from, end * 1e-7, this.#overTime ? 1e-3 : 2), end);
    const low = Math.min(Math.max(from, 0), end - span);
    this.#range = [low, low + span];
    this.#plot?.batch(() => {
      this.#plot!.setData(this.#data(), false);
      this.#plot!.setScale('x', { min: low, max: low + span });
      this.#plot!.setScale('y', { min: 0, max: Math.max(this.#top, 1) * 1.06 });
    });
  }

  #resize(): void {
    const { clientWidth: width, clientHeight: height } = this.#plotPlace;
    if (this.#app.times === undefined || width === 0 || height === 0) {
      return;
    }
    if (this.#plot !== undefined) {
      this.#plot.setSize({ width, height });
      return;
    }
    const { theme } = this.#view;
    const ink = theme.faint;
    const axis = {
      stroke: ink,
      grid: { stroke: css(theme.gridLine), width: 1 },
      ticks: { stroke: css(theme.gridStrong), width: 1 },
    };
    this.#plot = new uPlot(
      {
        width,
        height,
        legend: { show: false },
        cursor: { drag: { x: true, y: false, setScale: false }, points: { show: false } },
        scales: { x: { time: false }, y: { range: () => [0, Math.max(this.#top, 1) * 1.06] } },
        axes: [
          {
            ...axis,
            size: 30,
            label: () => t(this.#overTime ? 'axisTime' : 'axisBlocks'),
            labelSize: 14,
            labelGap: 0,
            labelFont: LABEL,
            incrs: () => (this.#overTime ? SECONDS : COUNTS),
            values: (_, ticks, __, ___, step) =>
              ticks.map((tick) => (this.#overTime ? tickTime(tick, step) : local(tick, 0))),
          },
          {
            ...axis,
            size: 62,
            label: () => t('axisFeed'),
            labelSize: 16,
            labelFont: LABEL,
            values: (_, ticks) => ticks.map((tick) => local(tick)),
          },
        ],
        series: [
          {},
          { stroke: css(PROGRAMMED(theme)), width: 1.2, dash: [5, 4], spanGaps: false, points: { show: false } },
          { stroke: css(theme.kinds[2]!), width: 1, dash: [2, 3], spanGaps: false, points: { show: false } },
          {
            stroke: css(theme.velocity),
            width: 1.6,
            spanGaps: false,
            points: { show: false },
            fill: `${css(theme.velocity)}22`,
          },
        ],
        hooks: {
          drawClear: [(plot) => this.#drawBlocks(plot)],
          draw: [(plot) => this.#drawOver(plot)],
          ready: [(plot) => this.#hands(plot)],
          setSelect: [(plot) => this.#selected(plot)],
        },
      },
      this.#data(),
      this.#plotPlace,
    );
    this.#plot.setScale('x', { min: this.#range[0], max: this.#range[1] });
  }

  #x(index: number): number {
    return this.#overTime ? this.#app.times!.startOf(index) : index;
  }

  #index(x: number): number {
    const { times, program } = this.#app;
    const index = this.#overTime ? times!.at(x) : Math.floor(x);
    return Math.min(Math.max(index, 0), program.count - 1);
  }

  /** The points in sight: x, programmed, cap, velocity. */
  #data(): Data {
    const { program, times } = this.#app;
    const data: Data = [[], [], [], []];
    if (program.count === 0 || times === undefined) {
      return data;
    }
    const [low, high] = this.#range;
    const first = Math.max(this.#index(low) - 1, 0);
    const last = Math.min(this.#index(high) + 1, program.count - 1);
    this.#scale(first, last);
    const put = (x: number, programmed: number | null, cap: number | null, velocity: number | null): void => {
      data[0].push(x);
      data[1].push(programmed);
      data[2].push(cap);
      data[3].push(velocity);
    };
    if (last - first < POINTS) {
      for (let index = first; index <= last; index += 1) {
        const x = this.#x(index);
        const end = this.#overTime ? x + times.durationOf(index) : index + 1;
        const known = times.velocities(index);
        if (known === undefined) {
          put(x, null, null, 0);
          put(end, null, null, 0);
          continue;
        }
        const { programmed, cap } = known;
        for (const [share, velocity] of times.shape(index)) {
          put(x + (end - x) * share, programmed, cap, velocity);
        }
      }
      return data;
    }
    const columns = 1200;
    const per = (last - first) / columns;
    for (let column = 0; column < columns; column += 1) {
      const from = Math.floor(first + column * per);
      const to = Math.max(Math.floor(first + (column + 1) * per), from + 1);
      let [least, most, programmed, cap] = [Infinity, 0, 0, 0];
      for (let index = from; index < to; index += 1) {
        const known = times.velocities(index);
        least = Math.min(least, known === undefined ? 0 : Math.min(known.start, known.end));
        if (known !== undefined) {
          most = Math.max(most, known.peak);
          programmed = Math.max(programmed, known.programmed);
          cap = Math.max(cap, known.cap);
        }
      }
      const x = this.#x(from);
      const next = this.#x(Math.min(to, program.count - 1));
      put(x, programmed, cap, least);
      put(x + (next - x) / 2, programmed, cap, most);
    }
    return data;
  }

  /** White lines between blocks, as the control draws them. */
  #drawBlocks(plot: uPlot): void {
    const [low, high] = this.#range;
    const { times } = this.#app;
    if (times === undefined) {
      return;
    }
    const [first, last] = [this.#index(low), this.#index(high)];
    if (last - first > LINES) {
      return;
    }
    const { ctx } = plot;
    const { top, height } = plot.bbox;
    ctx.save();
    ctx.strokeStyle = css(this.#view.theme.gridStrong);
    ctx.lineWidth = 1;
    for (let index = first; index <= last + 1 && index < this.#app.program.count; index += 1) {
      const x = Math.round(plot.valToPos(this.#x(index), 'x', true)) + 0.5;
      ctx.beginPath();
      ctx.moveTo(x, top);
      ctx.lineTo(x, top + height);
      ctx.stroke();
    }
    ctx.restore();
  }

  /** Caps of joints, velocities there as dots, and the block in hand. */
  #drawOver(plot: uPlot): void {
    const { times, current } = this.#app;
    if (times === undefined) {
      return;
    }
    const { ctx, bbox } = plot;
    const { theme } = this.#view;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    const [low, high] = this.#range;
    const [first, last] = [this.#index(low), this.#index(high)];
    const ratio = window.devicePixelRatio || 1;
    if (last - first <= POINTS) {
      for (let index = first; index <= last; index += 1) {
        const dot = times.dotOf(index);
        const cap = times.jointCap(index);
        if (cap !== undefined && last - first <= CAPS) {
          const [x, y] = [plot.valToPos(this.#x(index), 'x', true), plot.valToPos(cap, 'y', true)];
          ctx.beginPath();
          ctx.moveTo(x - 6 * ratio, y);
          ctx.lineTo(x + 6 * ratio, y);
          ctx.strokeStyle = css(theme.kinds[3]!);
          ctx.lineWidth = 2 * ratio;
          ctx.stroke();
        }
        if (dot === undefined) {
          continue;
        }
        const [x, y] = [plot.valToPos(this.#x(index), 'x', true), plot.valToPos(times.joint(index)!.feed, 'y', true)];
        const size = (dot === 'red' ? 4.5 : 3) * ratio;
        ctx.beginPath();
        if (dot === 'red') {
          ctx.moveTo(x, y - size);
          ctx.lineTo(x + size, y);
          ctx.lineTo(x, y + size);
          ctx.lineTo(x - size, y);
          ctx.closePath();
        } else {
          ctx.arc(x, y, size, 0, 2 * Math.PI);
        }
        ctx.fillStyle = css(dot === 'red' ? theme.red : theme.yellow);
        ctx.fill();
        ctx.strokeStyle = css(theme.dotEdge);
        ctx.lineWidth = ratio * 0.8;
        ctx.stroke();
      }
    }
    if (current !== null) {
      const from = plot.valToPos(this.#x(current), 'x', true);
      const to = plot.valToPos(this.#overTime ? this.#x(current) + times.durationOf(current) : current + 1, 'x', true);
      ctx.fillStyle = `${theme.selection}55`;
      ctx.fillRect(from, bbox.top, Math.max(to - from, 1), bbox.height);
      ctx.fillStyle = theme.selection;
      ctx.fillRect(from - ratio, bbox.top, 2 * ratio, bbox.height);
    }
    ctx.restore();
  }

  /** Arrows pan, plus and minus zoom about the block in hand, Home shows all. */
  #key(event: KeyboardEvent): void {
    const { times, current } = this.#app;
    if (times === undefined || event.ctrlKey || event.altKey || event.metaKey) {
      return;
    }
    const [low, high] = this.#range;
    const span = high - low;
    const hand = current === null ? NaN : this.#x(current);
    const at = hand >= low && hand <= high ? hand : (low + high) / 2;
    const zoom = (factor: number): void => this.#zoom(at - (at - low) * factor, at + (high - at) * factor);
    const actions: { [key: string]: () => void } = {
      ArrowLeft: () => this.#zoom(low - span / 8, high - span / 8),
      ArrowRight: () => this.#zoom(low + span / 8, high + span / 8),
      '+': () => zoom(0.7),
      '=': () => zoom(0.7),
      '-': () => zoom(1 / 0.7),
      Home: () => this.#whole(),
    };
    const action = actions[event.key];
    if (action !== undefined) {
      event.preventDefault();
      action();
    }
  }

  #hands(plot: uPlot): void {
    const over = plot.over;
    over.addEventListener(
      'wheel',
      (event) => {
        event.preventDefault();
        const [low, high] = this.#range;
        if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
          const by = ((event.deltaX || event.deltaY) / 600) * (high - low);
          this.#zoom(low + by, high + by);
          return;
        }
        const at = plot.posToVal(event.offsetX, 'x');
        const factor = Math.exp(event.deltaY * 0.0015);
        this.#zoom(at - (at - low) * factor, at + (high - at) * factor);
      },
      { passive: false },
    );
    over.addEventListener('dblclick', () => this.#whole());
    let pressed = 0;
    over.addEventListener('mousedown', (event) => {
      pressed = event.clientX;
    });
    over.addEventListener('mouseup', (event) => {
      if (Math.abs(event.clientX - pressed) < 3 && this.#app.program.count > 0) {
        const bounds = over.getBoundingClientRect();
        this.#app.select(this.#index(plot.posToVal(event.clientX - bounds.left, 'x')));
      }
    });
  }

  #selected(plot: uPlot): void {
    const { left, width } = plot.select;
    if (width > 3) {
      const [from, to] = [plot.posToVal(left, 'x'), plot.posToVal(left + width, 'x')];
      plot.setSelect({ left: 0, width: 0, top: 0, height: 0 }, false);
      this.#zoom(from, to);
    }
  }

  #tell(): void {
    const { current, program, times } = this.#app;
    if (current !== null && times !== undefined) {
      const x = this.#x(current);
      const [low, high] = this.#range;
      if (x < low || x > high) {
        this.#zoom(x - (high - low) / 2, x + (high - low) / 2);
      }
      const known = times.velocities(current);
      const parts = [clock(times.startOf(current))];
      if (known !== undefined) {
        parts.push(`${t('peak')} ${shown(known.peak, 1)} ${program.feedUnit(program.rowOf(current))}`);
      }
      this.#facts.textContent = parts.join(' · ');
    } else {
      this.#facts.textContent = '';
    }
    this.#plot?.redraw(false);
  }
}

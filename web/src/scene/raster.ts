// Draws the path without a graphics processor: smooth lines with depth into an array of pixels. Where a browser only
// imitates a graphics processor, this is ten times as fast as what it imitates.

import { DASHES, type Lines } from './lines.ts';
import type { Dots, Frame, Renderer } from './renderer.ts';

/** Lines are at least so long, in pixels of the screen, before they are drawn. */
const SHORT = 1;

export class Raster implements Renderer {
  readonly name = 'software';
  readonly #canvas: HTMLCanvasElement;
  readonly #context: CanvasRenderingContext2D;
  #image: ImageData;
  #pixels: Uint32Array;
  #depth: Float32Array;
  #width = 1;
  #height = 1;
  #ratio = 1;

  constructor(canvas: HTMLCanvasElement, context: CanvasRenderingContext2D) {
    this.#canvas = canvas;
    this.#context = context;
    this.#image = context.createImageData(1, 1);
    this.#pixels = new Uint32Array(this.#image.data.buffer);
    this.#depth = new Float32Array(1);
  }

  resize(width: number, height: number, ratio: number): void {
    const [w, h] = [Math.max(Math.round(width * ratio), 1), Math.max(Math.round(height * ratio), 1)];
    this.#ratio = ratio;
    if (w === this.#width && h === this.#height) {
      return;
    }
    [this.#width, this.#height] = [w, h];
    this.#canvas.width = w;
    this.#canvas.height = h;
    this.#image = this.#context.createImageData(w, h);
    this.#pixels = new Uint32Array(this.#image.data.buffer);
    this.#depth = new Float32Array(w * h);
  }

  changed(): void {
    // Every picture is drawn from the arrays.
  }

  draw(frame: Frame): void {
    this.#pixels.fill(frame.background);
    this.#depth.fill(-Infinity);
    this.#underlay(frame);
    const whole = (lines: Lines): void => this.#path({ ...frame, lines, until: lines.count });
    frame.under.forEach(whole);
    this.#path(frame);
    frame.over.forEach(whole);
    this.#dots(frame.dots, frame);
    this.#context.putImageData(this.#image, 0, 0);
  }

  #underlay({ underlay, matrix }: Frame): void {
    const m = matrix;
    const ratio = this.#ratio;
    underlay.colours.forEach((colour, i) => {
      const [a, b] = [underlay.points[2 * i]!, underlay.points[2 * i + 1]!];
      const x = (p: readonly number[]): number => (m[0]! * p[0]! + m[1]! * p[1]! + m[2]! * p[2]! + m[3]!) * ratio;
      const y = (p: readonly number[]): number => (m[4]! * p[0]! + m[5]! * p[1]! + m[6]! * p[2]! + m[7]!) * ratio;
      this.#line(x(a), y(a), -1e30, x(b), y(b), -1e30, colour, 0.5 * ratio, 0);
    });
  }

  #path({ lines, matrix, until, step, width }: Frame): void {
    const m = lines.about(matrix);
    const ratio = this.#ratio;
    const [m0, m1, m2, m3] = [m[0]! * ratio, m[1]! * ratio, m[2]! * ratio, m[3]! * ratio];
    const [m4, m5, m6, m7] = [m[4]! * ratio, m[5]! * ratio, m[6]! * ratio, m[7]! * ratio];
    const [m8, m9, m10, m11] = [m[8]!, m[9]!, m[10]!, m[11]!];
    const { points, colours, count } = lines;
    const half = (width * ratio) / 2;
    const [W, H] = [this.#width, this.#height];
    const runs = step > 1 ? lines.runs : undefined;
    // Dashes go on from chord to chord.
    let behind = -1;
    let dashBehind = 0;
    let travelled = 0;
    // What lies ahead is drawn first: it is faint.
    for (let pass = until < count ? 0 : 1; pass < 2; pass += 1) {
      const first = pass === 0 ? until : 0;
      const end = pass === 0 ? count : until;
      for (let chord = first; chord < end; ) {
        let last = chord;
        if (runs !== undefined) {
          last = Math.min(chord + step - 1, end - 1);
          const run = runs[chord]!;
          while (runs[last] !== run) {
            last -= 1;
          }
        }
        const at = 6 * chord;
        const to = 6 * last;
        const dash = lines.dash(chord);
        const [x, y, z] = [points[at]!, points[at + 1]!, points[at + 2]!];
        let [X, Y, Z] = [points[to + 3]!, points[to + 4]!, points[to + 5]!];
        const x0 = m0 * x + m1 * y + m2 * z + m3;
        let x1 = m0 * X + m1 * Y + m2 * Z + m3;
        const y0 = m4 * x + m5 * y + m6 * z + m7;
        let y1 = m4 * X + m5 * Y + m6 * Z + m7;
        // What is shorter than a pixel is drawn as one with what goes on from it.
        for (let next = to + 6; last + 1 < end && Math.abs(x1 - x0) + Math.abs(y1 - y0) < SHORT; next += 6) {
          const goesOn =
            points[next] === X && points[next + 1] === Y && points[next + 2] === Z && lines.dash(last + 1) === dash;
          if (!goesOn) {
            break;
          }
          last += 1;
          [X, Y, Z] = [points[next + 3]!, points[next + 4]!, points[next + 5]!];
          x1 = m0 * X + m1 * Y + m2 * Z + m3;
          y1 = m4 * X + m5 * Y + m6 * Z + m7;
        }
        if (dash !== 0) {
          const goesOn =
            dash === dashBehind &&
            points[at] === points[behind - 3] &&
            points[at + 1] === points[behind - 2] &&
            points[at + 2] === points[behind - 1];
          travelled = goesOn ? travelled : 0;
          behind = 6 * (last + 1);
          dashBehind = dash;
        }
        if (!((x0 < 0 && x1 < 0) || (y0 < 0 && y1 < 0) || (x0 > W && x1 > W) || (y0 > H && y1 > H))) {
          const z0 = m8 * x + m9 * y + m10 * z + m11;
          const z1 = m8 * X + m9 * Y + m10 * Z + m11;
          let colour = colours[2 * chord]!;
          const other = colours[2 * last + 1]!;
          if (pass === 0) {
            colour = (colour & 0xffffff) | 0x30000000;
          } else if (colour !== other && dash !== 0) {
            colour = mixed(colour, other, 0.5);
          } else if (colour !== other && Math.abs(x1 - x0) + Math.abs(y1 - y0) > 8) {
            this.#shaded(x0, y0, z0, x1, y1, z1, colour, other, half);
            chord = last + 1;
            continue;
          }
          this.#line(x0, y0, z0, x1, y1, z1, colour, half, dash, travelled);
        }
        if (dash !== 0) {
          travelled += Math.hypot(x1 - x0, y1 - y0);
        }
        chord = last + 1;
      }
    }
  }

  /** A line whose colour changes along it. */
  #shaded(
    x0: number,
    y0: number,
    z0: number,
    x1: number,
    y1: number,
    z1: number,
    from: number,
    to: number,
    half: number,
  ): void {
    const parts = Math.min(Math.ceil((Math.abs(x1 - x0) + Math.abs(y1 - y0)) / 6), 48);
    for (let part = 0; part < parts; part += 1) {
      const [a, b] = [part / parts, (part + 1) / parts];
      const colour = mixed(from, to, (a + b) / 2);
      this.#line(
        x0 + (x1 - x0) * a,
        y0 + (y1 - y0) * a,
        z0 + (z1 - z0) * a,
        x0 + (x1 - x0) * b,
        y0 + (y1 - y0) * b,
        z0 + (z1 - z0) * b,
        colour,
        half,
        0,
      );
    }
  }

  /** A line with soft edges, `half` as wide to both sides, in pixels. `before`: how far its dashes have come. */
  #line(
    x0: number,
    y0: number,
    z0: number,
    x1: number,
    y1: number,
    z1: number,
    colour: number,
    half: number,
    dash: number,
    before = 0,
  ): void {
    const [W, H] = [this.#width, this.#height];
    // Cut off what lies outside, by shares of the way.
    let begin = 0;
    let end = 1;
    const whole = Math.hypot(x1 - x0, y1 - y0);
    if (x0 < 0 || x1 < 0 || y0 < 0 || y1 < 0 || x0 >= W || x1 >= W || y0 >= H || y1 >= H) {
      const [dx, dy] = [x1 - x0, y1 - y0];
      for (const [p, q] of [
        [-dx, x0],
        [dx, W - 1 - x0],
        [-dy, y0],
        [dy, H - 1 - y0],
      ] as const) {
        if (p === 0) {
          if (q < 0) {
            return;
          }
        } else if (p < 0) {
          begin = Math.max(begin, q / p);
        } else {
          end = Math.min(end, q / p);
        }
      }
      if (begin > end) {
        return;
      }
    }
    const dz = z1 - z0;
    const [ax, ay, az] = [x0 + (x1 - x0) * begin, y0 + (y1 - y0) * begin, z0 + dz * begin];
    const [bx, by, bz] = [x0 + (x1 - x0) * end, y0 + (y1 - y0) * end, z0 + dz * end];
    const steep = Math.abs(by - ay) > Math.abs(bx - ax);
    // Along the longer side `u`, across it `v`.
    let [u0, v0, u1, v1, d0, d1] = steep ? [ay, ax, by, bx, az, bz] : [ax, ay, bx, by, az, bz];
    const lengths = DASHES[dash]!;
    const [solid, period] = [lengths[0] * this.#ratio, lengths[1] * this.#ratio];
    let travelled = before + whole * begin;
    let direction = 1;
    if (u1 < u0) {
      [u0, u1, v0, v1, d0, d1] = [u1, u0, v1, v0, d1, d0];
      travelled = before + whole * end;
      direction = -1;
    }
    const length = u1 - u0;
    const slope = length > 0 ? (v1 - v0) / length : 0;
    const fall = length > 0 ? (d1 - d0) / length : 0;
    const reach = half * Math.sqrt(1 + slope * slope);
    const perStep = Math.sqrt(1 + slope * slope) * direction;
    const first = Math.floor(u0);
    const last = Math.floor(u1);
    const limit = steep ? W : H;
    const [along, across] = steep ? [W, 1] : [1, W];
    const strength = (colour >>> 24) / 255;
    const pixels = this.#pixels;
    const depths = this.#depth;
    for (let u = first; u <= last; u += 1) {
      const centre = Math.min(Math.max(u + 0.5, u0), u1);
      if (dash > 0 && (travelled + (centre - u0) * perStep) % period > solid) {
        continue;
      }
      // The ends of a line cover a part of their pixel.
      const share = last === first ? Math.max(length, 0.6) : 1;
      const v = v0 + (centre - u0) * slope;
      const depth = d0 + (centre - u0) * fall;
      const low = v - reach;
      const high = v + reach;
      const top = Math.max(Math.floor(low), 0);
      const bottom = Math.min(Math.floor(high), limit - 1);
      for (let w = top; w <= bottom; w += 1) {
        const covered = (Math.min(high, w + 1) - Math.max(low, w)) * share * strength;
        const i = u * along + w * across;
        if (depth < depths[i]! - 1e-4 || covered <= 0) {
          continue;
        }
        if (covered > 0.5 && strength > 0.5) {
          depths[i] = depth;
        }
        const a = covered >= 1 ? 256 : (covered * 256) | 0;
        const under = pixels[i]!;
        const rest = 256 - a;
        const redBlue = (((under & 0xff00ff) * rest + (colour & 0xff00ff) * a) >>> 8) & 0xff00ff;
        const green = (((under & 0xff00) * rest + (colour & 0xff00) * a) >>> 8) & 0xff00;
        pixels[i] = 0xff000000 | redBlue | green;
      }
    }
  }

  /** Yellow dots are round, red ones stand on a corner and are larger. */
  #dots(dots: Dots, frame: Frame): void {
    const m = frame.matrix;
    const ratio = this.#ratio;
    const [W, H] = [this.#width, this.#height];
    const { points, red } = dots;
    for (let wanted = 0; wanted < 2; wanted += 1) {
      const size = (wanted === 1 ? 4.6 : 2.7) * ratio;
      const fill = wanted === 1 ? frame.dotColours.red : frame.dotColours.yellow;
      for (let dot = 0; dot < red.length; dot += 1) {
        if (red[dot] !== wanted) {
          continue;
        }
        const [x, y, z] = [points[3 * dot]!, points[3 * dot + 1]!, points[3 * dot + 2]!];
        const cx = (m[0]! * x + m[1]! * y + m[2]! * z + m[3]!) * ratio;
        const cy = (m[4]! * x + m[5]! * y + m[6]! * z + m[7]!) * ratio;
        if (cx < -size || cy < -size || cx > W + size || cy > H + size) {
          continue;
        }
        this.#stamp(cx, cy, size, wanted === 1, fill, frame.dotColours.edge);
      }
    }
  }

  #stamp(cx: number, cy: number, size: number, onCorner: boolean, fill: number, edge: number): void {
    const [W, H] = [this.#width, this.#height];
    const rim = 0.9 * this.#ratio;
    for (let y = Math.max(Math.floor(cy - size - 1), 0); y <= Math.min(cy + size + 1, H - 1); y += 1) {
      for (let x = Math.max(Math.floor(cx - size - 1), 0); x <= Math.min(cx + size + 1, W - 1); x += 1) {
        const [dx, dy] = [x + 0.5 - cx, y + 0.5 - cy];
        const far = onCorner ? Math.abs(dx) + Math.abs(dy) : Math.sqrt(dx * dx + dy * dy);
        const covered = Math.min(Math.max(size + 0.5 - far, 0), 1);
        if (covered > 0) {
          const i = y * W + x;
          this.#pixels[i] = mixed(this.#pixels[i]!, far > size - rim ? edge : fill, covered);
        }
      }
    }
  }
}

/** A colour between two, opaque. */
export function mixed(from: number, to: number, share: number): number {
  const part = (shift: number): number => {
    const [a, b] = [(from >>> shift) & 255, (to >>> shift) & 255];
    return Math.round(a + (b - a) * share) << shift;
  };
  return (0xff000000 | part(16) | part(8) | part(0)) >>> 0;
}

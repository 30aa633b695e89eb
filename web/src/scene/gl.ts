// Draws the path on a graphics processor, by WebGL 2 through twgl.

import * as twgl from 'twgl.js';

import { DASHES, type Lines } from './lines.ts';
import type { Frame, Renderer } from './renderer.ts';

const LINE_VERTEX = `#version 300 es
in vec3 position;
in vec4 colour;
in float travelled;
in float dashing;
uniform mat4 matrix;
uniform float scale;
uniform vec2 dashes[4];
uniform vec4 tint;
out vec4 ink;
out float dash;
out float solid;
void main() {
  gl_Position = matrix * vec4(position, 1.0);
  ink = vec4(colour.rgb, tint.a);
  vec2 lengths = dashes[int(dashing + 0.5)];
  dash = travelled * scale / lengths.y;
  solid = lengths.x / lengths.y;
}`;
const LINE_FRAGMENT = `#version 300 es
precision highp float;
in vec4 ink;
in float dash;
in float solid;
out vec4 result;
void main() {
  if (fract(dash) > solid) discard;
  result = ink;
}`;
const DOT_VERTEX = `#version 300 es
in vec3 position;
in float red;
uniform mat4 matrix;
uniform float ratio;
out float onCorner;
void main() {
  gl_Position = matrix * vec4(position, 1.0);
  gl_Position.z = -0.999;
  gl_PointSize = (red > 0.5 ? 11.0 : 7.0) * ratio;
  onCorner = red;
}`;
const DOT_FRAGMENT = `#version 300 es
precision highp float;
in float onCorner;
uniform vec3 redFill;
uniform vec3 yellowFill;
uniform vec3 edge;
out vec4 result;
void main() {
  vec2 at = abs(gl_PointCoord * 2.0 - 1.0);
  float far = onCorner > 0.5 ? at.x + at.y : length(at);
  if (far > 1.0) discard;
  result = vec4(far > 0.74 ? edge : onCorner > 0.5 ? redFill : yellowFill, 1.0);
}`;

const rgb = (colour: number): [number, number, number] => [
  (colour & 255) / 255,
  ((colour >> 8) & 255) / 255,
  ((colour >> 16) & 255) / 255,
];

export class Gl implements Renderer {
  readonly name = 'gl';
  readonly #gl: WebGL2RenderingContext;
  readonly #lineProgram: twgl.ProgramInfo;
  readonly #dotProgram: twgl.ProgramInfo;
  /** What is uploaded, with whether its colours are current. */
  #uploaded = new WeakMap<Lines, { info: twgl.BufferInfo; fresh: boolean }>();
  #current: Lines[] = [];
  #coarse = new WeakMap<Lines, { indices: WebGLBuffer; count: number; step: number }>();
  #dotBuffers: { of: object; info: twgl.BufferInfo } | undefined;
  #size: [number, number] = [1, 1];
  #ratio = 1;

  constructor(gl: WebGL2RenderingContext) {
    this.#gl = gl;
    this.#lineProgram = twgl.createProgramInfo(gl, [LINE_VERTEX, LINE_FRAGMENT]);
    this.#dotProgram = twgl.createProgramInfo(gl, [DOT_VERTEX, DOT_FRAGMENT]);
  }

  resize(width: number, height: number, ratio: number): void {
    this.#size = [width, height];
    this.#ratio = ratio;
    const canvas = this.#gl.canvas as HTMLCanvasElement;
    canvas.width = Math.max(Math.round(width * ratio), 1);
    canvas.height = Math.max(Math.round(height * ratio), 1);
  }

  changed(what: 'points' | 'colours'): void {
    for (const lines of this.#current) {
      const uploaded = this.#uploaded.get(lines);
      if (what === 'points') {
        this.#uploaded.delete(lines);
      } else if (uploaded !== undefined) {
        uploaded.fresh = false;
      }
    }
  }

  /** The projection to clip space. Depths of the whole drawing fit. */
  #matrix(m: Float64Array, reach: number): Float32Array {
    const [w, h] = this.#size;
    const x = 2 / w;
    const y = -2 / h;
    const z = -1 / (reach || 1);
    return new Float32Array([
      m[0]! * x,
      m[4]! * y,
      m[8]! * z,
      0,
      m[1]! * x,
      m[5]! * y,
      m[9]! * z,
      0,
      m[2]! * x,
      m[6]! * y,
      m[10]! * z,
      0,
      m[3]! * x - 1,
      m[7]! * y + 1,
      m[11]! * z * 0.5,
      1,
    ]);
  }

  #upload(lines: Lines): twgl.BufferInfo {
    const gl = this.#gl;
    const uploaded = this.#uploaded.get(lines);
    if (uploaded === undefined) {
      const { points, count } = lines;
      const travelled = new Float32Array(2 * count);
      const dashing = new Uint8Array(2 * count);
      for (let chord = 0, at = 0; chord < count; chord += 1, at += 6) {
        const dash = lines.dash(chord);
        if (dash === 0) {
          continue;
        }
        dashing.fill(dash, 2 * chord, 2 * chord + 2);
        const goesOn =
          chord > 0 &&
          dashing[2 * chord - 1] === dash &&
          points[at] === points[at - 3] &&
          points[at + 1] === points[at - 2] &&
          points[at + 2] === points[at - 1];
        const from = goesOn ? travelled[2 * chord - 1]! : 0;
        travelled[2 * chord] = from;
        travelled[2 * chord + 1] =
          from +
          Math.hypot(
            points[at + 3]! - points[at]!,
            points[at + 4]! - points[at + 1]!,
            points[at + 5]! - points[at + 2]!,
          );
      }
      const info = twgl.createBufferInfoFromArrays(gl, {
        position: { numComponents: 3, data: points },
        travelled: { numComponents: 1, data: travelled },
        dashing: { numComponents: 1, data: dashing, normalize: false },
        colour: { numComponents: 4, data: new Uint8Array(lines.colours.buffer), normalize: true },
      });
      this.#uploaded.set(lines, { info, fresh: true });
      this.#coarse.delete(lines);
      return info;
    }
    if (!uploaded.fresh) {
      twgl.setAttribInfoBufferFromArray(gl, uploaded.info.attribs!['colour']!, new Uint8Array(lines.colours.buffer));
      uploaded.fresh = true;
    }
    return uploaded.info;
  }

  #coarseIndices(lines: Lines, step: number): { indices: WebGLBuffer; count: number } {
    let coarse = this.#coarse.get(lines);
    if (coarse?.step !== step) {
      const gl = this.#gl;
      const found: number[] = [];
      const runs = lines.runs;
      for (let chord = 0; chord < lines.count; ) {
        let last = Math.min(chord + step - 1, lines.count - 1);
        while (runs[last] !== runs[chord]) {
          last -= 1;
        }
        found.push(2 * chord, 2 * last + 1);
        chord = last + 1;
      }
      const indices = gl.createBuffer()!;
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(found), gl.STATIC_DRAW);
      coarse = { indices, count: found.length, step };
      this.#coarse.set(lines, coarse);
    }
    return coarse;
  }

  draw(frame: Frame): void {
    const gl = this.#gl;
    const { lines, under, over } = frame;
    this.#current = [...under, lines, ...over];
    gl.viewport(0, 0, gl.canvas.width, gl.canvas.height);
    gl.clearColor(...rgb(frame.background), 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    this.#drawUnderlay(frame);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    for (const layer of this.#current) {
      this.#drawLines(frame, layer, layer === lines ? frame.until : layer.count);
    }
    gl.disable(gl.DEPTH_TEST);
    this.#drawDots(frame);
  }

  #drawLines(frame: Frame, lines: Lines, end: number): void {
    const gl = this.#gl;
    const box = lines.path.box;
    const reach = Math.hypot(...box.min.map((low, i) => box.max[i]! - low)) + 1;
    const around = lines.about(frame.matrix);
    // Depths count from the middle of the drawing.
    around[11] = 0;
    const buffers = this.#upload(lines);
    gl.useProgram(this.#lineProgram.program);
    twgl.setBuffersAndAttributes(gl, this.#lineProgram, buffers);
    const scale = Math.hypot(frame.matrix[0]!, frame.matrix[4]!) || 1;
    const uniforms = { matrix: this.#matrix(around, reach), scale, dashes: DASHES.flat(), tint: [1, 1, 1, 1] };
    const until = 2 * end;
    const all = 2 * lines.count;
    if (frame.step > 1) {
      const { indices, count } = this.#coarseIndices(lines, frame.step);
      twgl.setUniforms(this.#lineProgram, uniforms);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices);
      gl.drawElements(gl.LINES, count, gl.UNSIGNED_INT, 0);
    } else {
      if (until < all) {
        twgl.setUniforms(this.#lineProgram, { ...uniforms, tint: [1, 1, 1, 0.19] });
        gl.drawArrays(gl.LINES, until, all - until);
      }
      twgl.setUniforms(this.#lineProgram, uniforms);
      gl.drawArrays(gl.LINES, 0, until);
    }
  }

  #drawUnderlay(frame: Frame): void {
    const gl = this.#gl;
    const { points, colours } = frame.underlay;
    gl.disable(gl.DEPTH_TEST);
    if (points.length === 0) {
      return;
    }
    const info = twgl.createBufferInfoFromArrays(gl, {
      position: { numComponents: 3, data: points.flat() },
      travelled: { numComponents: 1, data: new Float32Array(points.length) },
      dashing: { numComponents: 1, data: new Uint8Array(points.length), normalize: false },
      colour: {
        numComponents: 4,
        data: new Uint8Array(Uint32Array.from(colours.flatMap((c) => [c, c])).buffer),
        normalize: true,
      },
    });
    gl.useProgram(this.#lineProgram.program);
    twgl.setBuffersAndAttributes(gl, this.#lineProgram, info);
    const flat = frame.matrix.slice();
    flat.fill(0, 8);
    twgl.setUniforms(this.#lineProgram, {
      matrix: this.#matrix(flat, 1),
      scale: 0,
      dashes: DASHES.flat(),
      tint: [1, 1, 1, 1],
    });
    gl.drawArrays(gl.LINES, 0, points.length);
    for (const attribute of Object.values(info.attribs ?? {})) {
      gl.deleteBuffer(attribute.buffer ?? null);
    }
  }

  #drawDots(frame: Frame): void {
    const gl = this.#gl;
    const { dots } = frame;
    if (dots.red.length === 0) {
      return;
    }
    if (this.#dotBuffers?.of !== dots) {
      const info = twgl.createBufferInfoFromArrays(gl, {
        position: { numComponents: 3, data: dots.points },
        red: { numComponents: 1, data: Float32Array.from(dots.red) },
      });
      this.#dotBuffers = { of: dots, info };
    }
    gl.useProgram(this.#dotProgram.program);
    twgl.setBuffersAndAttributes(gl, this.#dotProgram, this.#dotBuffers.info);
    const flat = frame.matrix.slice();
    flat.fill(0, 8);
    twgl.setUniforms(this.#dotProgram, {
      matrix: this.#matrix(flat, 1),
      ratio: this.#ratio,
      redFill: rgb(frame.dotColours.red),
      yellowFill: rgb(frame.dotColours.yellow),
      edge: rgb(frame.dotColours.edge),
    });
    gl.drawArrays(gl.POINTS, 0, dots.red.length);
  }
}

/** A context on a graphics processor; nothing where there is none, or the browser only imitates one. */
export function hardwareContext(canvas: HTMLCanvasElement, forced: boolean): WebGL2RenderingContext | null {
  if (!forced) {
    // Another canvas is asked: one canvas takes one kind of context.
    const probe = document.createElement('canvas').getContext('webgl2', { failIfMajorPerformanceCaveat: true });
    const unmasked = probe?.getExtension('WEBGL_debug_renderer_info')?.UNMASKED_RENDERER_WEBGL;
    const name: unknown = probe?.getParameter(unmasked ?? probe.RENDERER);
    if (typeof name !== 'string' || /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name)) {
      return null;
    }
  }
  return canvas.getContext('webgl2', { antialias: true, preserveDrawingBuffer: true });
}

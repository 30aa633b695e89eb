// Where the path is seen from: a parallel projection onto the canvas.

export type Vector = [number, number, number];

/** A box around points, in millimetres. */
export interface Box {
  min: Vector;
  max: Vector;
}

export type Plane = 'XY' | 'XZ' | 'YZ' | 'ZX' | 'iso';

/** Directions to the right and up; the third, towards the eye, follows. */
const DIRECTIONS: { [plane in Plane]: [Vector, Vector] } = {
  XY: [
    [1, 0, 0],
    [0, 1, 0],
  ],
  XZ: [
    [1, 0, 0],
    [0, 0, 1],
  ],
  YZ: [
    [0, 1, 0],
    [0, 0, 1],
  ],
  // As a lathe is drawn.
  ZX: [
    [0, 0, 1],
    [1, 0, 0],
  ],
  // From X-Y-Z+.
  iso: [
    [Math.SQRT1_2, -Math.SQRT1_2, 0],
    [1 / Math.sqrt(6), 1 / Math.sqrt(6), 2 / Math.sqrt(6)],
  ],
};

function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function turned(vector: Vector, axis: Vector, angle: number): Vector {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const along = axis[0] * vector[0] + axis[1] * vector[1] + axis[2] * vector[2];
  const across = cross(axis, vector);
  return vector.map((value, i) => value * cos + across[i]! * sin + axis[i]! * along * (1 - cos)) as Vector;
}

function unit(vector: Vector): Vector {
  const length = Math.hypot(...vector) || 1;
  return vector.map((value) => value / length) as Vector;
}

export class Camera {
  /** The canvas, in CSS pixels. */
  width = 1;
  height = 1;
  right: Vector = DIRECTIONS.iso[0];
  up: Vector = DIRECTIONS.iso[1];
  /** What is in the middle of the canvas. */
  target: Vector = [0, 0, 0];
  /** CSS pixels a millimetre. */
  scale = 1;

  /** From the drawing to the eye. */
  get towards(): Vector {
    return cross(this.right, this.up);
  }

  /** Looks at a plane. */
  look(plane: Plane): void {
    [this.right, this.up] = DIRECTIONS[plane];
  }

  /** Shows all of a box. `margin`: CSS pixels left free at the left, top, right, bottom. */
  fit(box: Box, margin: [number, number, number, number]): void {
    const [left, top, right, bottom] = margin;
    this.target = box.min.map((low, i) => (low + box.max[i]!) / 2) as Vector;
    const size = box.min.map((low, i) => box.max[i]! - low) as Vector;
    const extent = (direction: Vector): number =>
      Math.abs(direction[0]) * size[0] + Math.abs(direction[1]) * size[1] + Math.abs(direction[2]) * size[2];
    const width = Math.max(this.width - left - right, 20);
    const height = Math.max(this.height - top - bottom, 20);
    const wide = Math.max(extent(this.right), 1e-3);
    const high = Math.max(extent(this.up), 1e-3);
    this.scale = Math.min(width / wide, height / high);
    this.pan((left - right) / 2, (top - bottom) / 2);
  }

  /** Turns about the vertical and about the direction to the right, by radians. */
  turn(about: number, over: number): void {
    const vertical: Vector = [0, 0, 1];
    let right = turned(this.right, vertical, about);
    let up = turned(this.up, vertical, about);
    up = turned(up, right, over);
    right = unit(right);
    const along = up[0] * right[0] + up[1] * right[1] + up[2] * right[2];
    this.right = right;
    this.up = unit(up.map((value, i) => value - along * right[i]!) as Vector);
  }

  /** Moves the drawing by CSS pixels. */
  pan(x: number, y: number): void {
    this.target = this.target.map((value, i) => value - (this.right[i]! * x - this.up[i]! * y) / this.scale) as Vector;
  }

  /** Zooms about a point of the canvas. */
  zoom(factor: number, x = this.width / 2, y = this.height / 2): void {
    const [dx, dy] = [x - this.width / 2, y - this.height / 2];
    this.pan(-dx, -dy);
    this.scale = Math.min(Math.max(this.scale * factor, 1e-6), 1e7);
    this.pan(dx, dy);
  }

  /** Coefficients of the projection: x = m0·X + m1·Y + m2·Z + m3, y = m4…m7 (down), depth = m8…m11 (greater is nearer). */
  matrix(): Float64Array {
    const { right, up, towards, target, scale } = this;
    const dot = (a: Vector): number => a[0] * target[0] + a[1] * target[1] + a[2] * target[2];
    return new Float64Array([
      right[0] * scale,
      right[1] * scale,
      right[2] * scale,
      this.width / 2 - dot(right) * scale,
      -up[0] * scale,
      -up[1] * scale,
      -up[2] * scale,
      this.height / 2 + dot(up) * scale,
      towards[0],
      towards[1],
      towards[2],
      -dot(towards),
    ]);
  }

  /** Where a point stands on the canvas, in CSS pixels. */
  project(point: Vector): { x: number; y: number } {
    const m = this.matrix();
    return {
      x: m[0]! * point[0] + m[1]! * point[1] + m[2]! * point[2] + m[3]!,
      y: m[4]! * point[0] + m[5]! * point[1] + m[6]! * point[2] + m[7]!,
    };
  }
}

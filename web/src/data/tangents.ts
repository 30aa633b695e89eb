// Directions of motions at their ends, as src/view/tangents.rs computes them.

import type { Program } from './program.ts';

/** The angle between two motions where they join, in degrees, by their directions in the first three linear axes. */
export function angle(program: Program, before: number, after: number): number {
  const [ax, ay, az] = tangent(program, before, true);
  const [bx, by, bz] = tangent(program, after, false);
  const cross = [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx] as const;
  const length = Math.sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]);
  return (Math.atan2(length, ax * bx + ay * by + az * bz) * 180) / Math.PI;
}

/** The direction at the start or end of a row's motion; its length means nothing. */
export function tangent(program: Program, row: number, atEnd: boolean): [number, number, number] {
  const before = program.before[row]!;
  const way = (axis: number): number =>
    (program.position[axis]![row]! - program.position[axis]![before]!) / program.per[axis]!;
  const shape = program.shapeOf(row);
  const direction: [number, number, number] = [0, 0, 0];
  let [u, v, du, dv, sweep] = [-1, -1, 0, 0, 1];
  if (shape.r !== undefined) {
    [u, v] = [program.letters.indexOf(shape.r[0]!), program.letters.indexOf(shape.r[1]!)];
    const [toU, toV] = program.toCenter(row);
    const [fromU, fromV] = atEnd ? [way(u) - toU, way(v) - toV] : [-toU, -toV];
    const turn = program.sweep(row, shape);
    sweep = Math.abs(turn);
    [du, dv] = turn < 0 ? [fromV, -fromU] : [-fromV, fromU];
  }
  program.linear.forEach((axis, i) => {
    direction[i] = axis === u ? du : axis === v ? dv : way(axis) / sweep;
  });
  return direction;
}

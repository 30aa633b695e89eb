// Which line runs by a place of the canvas.

import type { Vector } from './camera.ts';
import type { View } from './view.ts';

/** How far from a line a place may be, in CSS pixels. */
const REACH = 5;
/** Lines are equally near when they differ by less than this, in CSS pixels. */
const EQUAL = 0.01;

export function pick(view: View, x: number, y: number): { index: number; point: Vector } | null {
  const { lines, app, camera } = view;
  const m = lines.about(camera.matrix());
  const { points, rows, count } = lines;
  const [m0, m1, m2, m3] = [m[0]!, m[1]!, m[2]!, m[3]! - x];
  const [m4, m5, m6, m7] = [m[4]!, m[5]!, m[6]!, m[7]! - y];
  const { program } = app;
  const currentRow = app.current === null ? -1 : program.rowOf(app.current);
  let best = REACH * REACH;
  let chord = -1;
  let share = 0;
  let last = -1;
  let current: { chord: number; share: number; far: number } | undefined;
  for (let i = 0, at = 0; i < count; i += 1, at += 6) {
    const ax = m0 * points[at]! + m1 * points[at + 1]! + m2 * points[at + 2]! + m3;
    const bx = m0 * points[at + 3]! + m1 * points[at + 4]! + m2 * points[at + 5]! + m3;
    if ((ax > REACH && bx > REACH) || (ax < -REACH && bx < -REACH)) {
      continue;
    }
    const ay = m4 * points[at]! + m5 * points[at + 1]! + m6 * points[at + 2]! + m7;
    const by = m4 * points[at + 3]! + m5 * points[at + 4]! + m6 * points[at + 5]! + m7;
    if ((ay > REACH && by > REACH) || (ay < -REACH && by < -REACH)) {
      continue;
    }
    const [dx, dy] = [bx - ax, by - ay];
    const length = dx * dx + dy * dy;
    const along = length > 0 ? Math.min(Math.max(-(ax * dx + ay * dy) / length, 0), 1) : 0;
    const [nx, ny] = [ax + dx * along, ay + dy * along];
    const far = nx * nx + ny * ny;
    if (far > REACH * REACH) {
      continue;
    }
    if (rows[i] === currentRow && (current === undefined || far < current.far)) {
      current = { chord: i, share: along, far };
    }
    const difference = Math.sqrt(far) - Math.sqrt(best);
    const executed = program.lastIndexOf(rows[i]!);
    if (difference < -EQUAL || (difference <= EQUAL && executed > last)) {
      best = difference < 0 || chord < 0 ? far : best;
      chord = i;
      share = along;
      last = executed;
    }
  }
  if (current !== undefined) {
    ({ chord, share } = current);
  }
  if (chord < 0) {
    return null;
  }
  const at = 6 * chord;
  const point = [0, 1, 2].map(
    (i) => points[at + i]! + (points[at + 3 + i]! - points[at + i]!) * share + lines.origin[i]!,
  ) as Vector;
  let index = current === undefined ? last : app.current!;
  if (app.isFiltered && app.isHidden(index)) {
    const seen = program.executionsOfRow(rows[chord]!).filter((execution) => !app.isHidden(execution));
    index = seen[seen.length - 1] ?? index;
  }
  return { index, point };
}

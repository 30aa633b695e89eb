// The grid under the path: in the plane that is seen most from above, at the far side of the box.

import type { Box, Camera, Vector } from './camera.ts';
import type { Theme } from './colours.ts';
import type { Underlay } from './renderer.ts';

export interface GridLabel {
  /** The end of the line that it belongs to, and the other end. */
  at: Vector;
  far: Vector;
  /** Away from the grid, for placing the text. */
  outward: Vector;
  text: string;
}

/** Room at the edges of the canvas that texts leave free, in CSS pixels. */
const EDGE = 3;
/** Height of a text above its line, and below. */
const [ABOVE, BELOW] = [11, 4];

/** 1, 2 or 5 times a power of ten, at least so much. */
export function roundStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  const lead = least / power;
  return power * (lead <= 1 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10);
}

export function grid(
  box: Box,
  camera: Camera,
  theme: Theme,
  diameter = false,
): { underlay: Underlay; labels: GridLabel[] } {
  const all: [number, number] = [-Infinity, Infinity];
  const towards = camera.towards;
  const normal = [0, 1, 2].reduce(
    (best, axis) => (Math.abs(towards[axis]!) > Math.abs(towards[best]!) + 1e-9 ? axis : best),
    2,
  );
  const level = towards[normal]! >= 0 ? box.min[normal]! : box.max[normal]!;
  const [a, b] = [0, 1, 2].filter((axis) => axis !== normal) as [number, number];
  const step = roundStep(56 / camera.scale);
  const range = (axis: number): [number, number] => {
    const low = Math.floor(box.min[axis]! / step - 1e-9);
    const high = Math.ceil(box.max[axis]! / step + 1e-9);
    return low === high ? [low - 1, high + 1] : [low, high];
  };
  // Only what can be seen is drawn.
  const [seenA, seenB] = inSight(camera, [a, b, normal], level);
  const within = ([low, high]: [number, number], [least, most]: [number, number]): [number, number] => [
    Math.max(low, Math.floor(least / step)),
    Math.min(high, Math.ceil(most / step)),
  ];
  const point = (u: number, v: number): Vector => {
    const found: Vector = [0, 0, 0];
    found[normal] = level;
    found[a] = u * step;
    found[b] = v * step;
    return found;
  };
  // Labels stand along the edges that are lowest and leftmost on the canvas.
  const lowest = (axis: number): boolean => camera.up[axis]! + camera.right[axis]! * 1e-3 >= 0;
  const leftmost = (axis: number): boolean => camera.right[axis]! + camera.up[axis]! * 1e-3 >= 0;
  /** Positions along X are radii. */
  const number = (value: number, axis: number): string =>
    String(Number((value * step * (diameter && axis === 0 ? 2 : 1)).toPrecision(12)));
  const over = (
    [lowA, highA]: [number, number],
    [lowB, highB]: [number, number],
  ): { underlay: Underlay; labels: GridLabel[] } => {
    const underlay: Underlay = { points: [], colours: [] };
    const labels: GridLabel[] = [];
    const line = (from: Vector, to: Vector, strong: boolean): void => {
      underlay.points.push(from, to);
      underlay.colours.push(strong ? theme.gridStrong : theme.gridLine);
    };
    const edgeB = (Math.abs(camera.up[b]!) >= Math.abs(camera.right[b]!) ? lowest(b) : leftmost(b)) ? lowB : highB;
    const edgeA = (Math.abs(camera.right[a]!) >= Math.abs(camera.up[a]!) ? leftmost(a) : lowest(a)) ? lowA : highA;
    const outwardB: Vector = [0, 0, 0];
    outwardB[b] = edgeB === lowB ? -1 : 1;
    const outwardA: Vector = [0, 0, 0];
    outwardA[a] = edgeA === lowA ? -1 : 1;
    for (let u = lowA; u <= highA; u += 1) {
      line(point(u, lowB), point(u, highB), u === 0);
      labels.push({ at: point(u, edgeB), far: point(u, lowB + highB - edgeB), outward: outwardB, text: number(u, a) });
    }
    for (let v = lowB; v <= highB; v += 1) {
      line(point(lowA, v), point(highA, v), v === 0);
      labels.push({ at: point(edgeA, v), far: point(lowA + highA - edgeA, v), outward: outwardA, text: number(v, b) });
    }
    return { underlay, labels };
  };
  const found = over(within(range(a), seenA), within(range(b), seenB));
  const isSeen = ({ at, far }: GridLabel): boolean =>
    enters(camera.project(at), camera.project(far), camera) !== undefined;
  // Where the box ends out of sight, as over a part of it, the grid goes on as far as can be seen.
  return found.labels.filter(isSeen).length >= 2 ? found : over(within(all, seenA), within(all, seenB));
}

/** Which coordinates of a plane, along its axes `a` and `b`, are on the canvas. */
function inSight(camera: Camera, [a, b, normal]: Vector, level: number): [[number, number], [number, number]] {
  const m = camera.matrix();
  const [xa, xb, ya, yb] = [m[a]!, m[b]!, m[4 + a]!, m[4 + b]!];
  const determinant = xa * yb - xb * ya;
  const along: [number[], number[]] = [[], []];
  for (const [x, y] of [
    [0, 0],
    [camera.width, 0],
    [0, camera.height],
    [camera.width, camera.height],
  ] as const) {
    const [dx, dy] = [x - m[3]! - m[normal]! * level, y - m[7]! - m[4 + normal]! * level];
    along[0].push((dx * yb - dy * xb) / determinant);
    along[1].push((dy * xa - dx * ya) / determinant);
  }
  return along.map((values) => [Math.min(...values), Math.max(...values)]) as [[number, number], [number, number]];
}

/** Where texts stand on the canvas: beyond the ends of their lines, else where these leave the canvas. */
export function placeLabels(
  labels: GridLabel[],
  camera: Camera,
  widthOf: (text: string) => number,
): { text: string; x: number; y: number }[] {
  return labels.flatMap(({ at, far, outward, text }) => {
    const from = camera.project(at);
    const share = enters(from, camera.project(far), camera);
    if (share === undefined) {
      return [];
    }
    const width = widthOf(text);
    let [x, y] = [from.x - width / 2, from.y];
    if (share === 0) {
      const to = camera.project(at.map((value, i) => value + outward[i]!) as Vector);
      const length = Math.hypot(to.x - from.x, to.y - from.y) || 1;
      x += ((to.x - from.x) / length) * (10 + width / 2);
      y += ((to.y - from.y) / length) * 12;
    } else {
      const end = camera.project(far);
      x += (end.x - from.x) * share;
      y += (end.y - from.y) * share;
    }
    return [
      {
        text,
        x: Math.min(Math.max(x, EDGE), camera.width - EDGE - width),
        y: Math.min(Math.max(y + BELOW, EDGE + ABOVE), camera.height - EDGE - BELOW),
      },
    ];
  });
}

/** At which share of its way from one point to another a line comes onto the canvas; nothing when it does not. */
function enters(from: { x: number; y: number }, to: { x: number; y: number }, camera: Camera): number | undefined {
  let [begin, end] = [0, 1];
  for (const [start, way, most] of [
    [from.x, to.x - from.x, camera.width],
    [from.y, to.y - from.y, camera.height],
  ] as const) {
    if (way === 0) {
      if (start < 0 || start > most) {
        return undefined;
      }
      continue;
    }
    const [one, other] = [-start / way, (most - start) / way];
    begin = Math.max(begin, Math.min(one, other));
    end = Math.min(end, Math.max(one, other));
  }
  return begin > end ? undefined : begin;
}

// The grid under the path: in the plane that is seen most from above, at the far side of the box.

import type { Box, Camera, Vector } from './camera.ts';
import type { Theme } from './colours.ts';
import type { Underlay } from './renderer.ts';

export interface GridLabel {
  at: Vector;
  /** Away from the grid, for placing the text. */
  outward: Vector;
  text: string;
}

/** 1, 2 or 5 times a power of ten, at least so much. */
export function roundStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  const lead = least / power;
  return power * (lead <= 1 ? 1 : lead <= 2 ? 2 : lead <= 5 ? 5 : 10);
}

export function grid(box: Box, camera: Camera, theme: Theme): { underlay: Underlay; labels: GridLabel[] } {
  const underlay: Underlay = { points: [], colours: [] };
  const labels: GridLabel[] = [];
  const towards = camera.towards;
  const normal = [0, 1, 2].reduce((best, axis) => (Math.abs(towards[axis]!) > Math.abs(towards[best]!) + 1e-9 ? axis : best), 2);
  const level = towards[normal]! >= 0 ? box.min[normal]! : box.max[normal]!;
  const [a, b] = [0, 1, 2].filter((axis) => axis !== normal) as [number, number];
  const step = roundStep(56 / camera.scale);
  const range = (axis: number): [number, number] => {
    const low = Math.floor(box.min[axis]! / step - 1e-9);
    const high = Math.ceil(box.max[axis]! / step + 1e-9);
    return low === high ? [low - 1, high + 1] : [low, high];
  };
  const [lowA, highA] = range(a);
  const [lowB, highB] = range(b);
  // Far zoomed in, only what can be seen is drawn.
  if (highA - lowA > 400 || highB - lowB > 400) {
    return { underlay, labels };
  }
  const point = (u: number, v: number): Vector => {
    const found: Vector = [0, 0, 0];
    found[normal] = level;
    found[a] = u * step;
    found[b] = v * step;
    return found;
  };
  const line = (from: Vector, to: Vector, strong: boolean): void => {
    underlay.points.push(from, to);
    underlay.colours.push(strong ? theme.gridStrong : theme.gridLine);
  };
  // Labels stand along the edges that are lowest and leftmost on the canvas.
  const lowest = (axis: number): boolean => camera.up[axis]! + camera.right[axis]! * 1e-3 >= 0;
  const leftmost = (axis: number): boolean => camera.right[axis]! + camera.up[axis]! * 1e-3 >= 0;
  const edgeB = (Math.abs(camera.up[b]!) >= Math.abs(camera.right[b]!) ? lowest(b) : leftmost(b)) ? lowB : highB;
  const edgeA = (Math.abs(camera.right[a]!) >= Math.abs(camera.up[a]!) ? leftmost(a) : lowest(a)) ? lowA : highA;
  const outwardB: Vector = [0, 0, 0];
  outwardB[b] = edgeB === lowB ? -1 : 1;
  const outwardA: Vector = [0, 0, 0];
  outwardA[a] = edgeA === lowA ? -1 : 1;
  const number = (value: number): string => String(Number((value * step).toPrecision(12)));
  for (let u = lowA; u <= highA; u += 1) {
    line(point(u, lowB), point(u, highB), u === 0);
    labels.push({ at: point(u, edgeB), outward: outwardB, text: number(u) });
  }
  for (let v = lowB; v <= highB; v += 1) {
    line(point(lowA, v), point(highA, v), v === 0);
    labels.push({ at: point(edgeA, v), outward: outwardA, text: number(v) });
  }
  return { underlay, labels };
}

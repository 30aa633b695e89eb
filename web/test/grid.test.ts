// The grid has numbers from wherever it is seen; numbers at dots that would cover each other stand once.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { type Box, Camera, type Plane, type Vector } from '../src/scene/camera.ts';
import { LIGHT } from '../src/scene/colours.ts';
import { grid, placeLabels } from '../src/scene/grid.ts';
import { joined, type Numbers, said } from '../src/scene/marks.ts';

const BOXES: [string, Box][] = [
  ['flat', { min: [0, 0, 0], max: [50, 50, 0] }],
  ['wide', { min: [-900, 3, -20], max: [1200, 9, 5] }],
  ['tiny', { min: [0.01, 0.02, 0], max: [0.013, 0.021, 0] }],
  ['tall', { min: [0, 0, -400], max: [100, 120, 100] }],
];

for (const [name, box] of BOXES) {
  for (const plane of ['XY', 'XZ', 'YZ', 'iso'] as Plane[]) {
    test(`numbers at the grid: ${name}, ${plane}`, () => {
      for (const [width, height] of [
        [880, 470],
        [1900, 900],
        [320, 240],
      ] as const) {
        for (const zoom of [1e-3, 0.1, 1, 7, 300, 20_000]) {
          const camera = new Camera();
          [camera.width, camera.height] = [width, height];
          camera.look(plane);
          camera.fit(box, [52, 48, 52, 48]);
          camera.zoom(zoom);
          const { underlay, labels } = grid(box, camera, LIGHT);
          const placed = placeLabels(labels, camera, (text) => 6 * text.length);
          assert.ok(underlay.colours.length < 600, `${underlay.colours.length} lines`);
          assert.ok(placed.length >= 2, `${width} ${zoom}: ${placed.length} numbers`);
          for (const { text, x, y } of placed) {
            assert.ok(
              x >= 0 && y >= 11 && x + 6 * text.length <= width && y <= height,
              `${width} ${zoom}: ${text} ${x} ${y}`,
            );
          }
        }
      }
    });
  }
}

test('a grid that is zoomed into has numbers along both axes', () => {
  const camera = new Camera();
  [camera.width, camera.height] = [880, 470];
  camera.look('XY');
  camera.fit({ min: [0, 0, 0], max: [50, 50, 0] }, [52, 48, 52, 48]);
  camera.zoom(5000);
  const { labels } = grid({ min: [0, 0, 0], max: [50, 50, 0] }, camera, LIGHT);
  const placed = placeLabels(labels, camera, () => 30);
  const along = (axis: 'x' | 'y'): number => new Set(placed.map((label) => Math.round(label[axis]))).size;
  assert.ok(along('x') > 4 && along('y') > 4);
});

test('numbers stand once', () => {
  const dot = (n: number, x: number): Numbers => ({ x, y: 50, first: n, last: n, count: 1 });
  const box = (number: Numbers): [number, number, number, number] => [
    number.x,
    number.y - 11,
    number.x + 7 * said(number).length,
    number.y + 4,
  ];
  const texts = (numbers: Numbers[]): string[] => joined(numbers, box).map(said);
  assert.deepEqual(texts([dot(110, 0), dot(120, 300)]), ['N110', 'N120']);
  assert.deepEqual(texts([dot(110, 0), dot(110, 0), dot(110, 1)]), ['N110 ×3']);
  assert.deepEqual(texts([dot(110, 0), dot(120, 5), dot(210, 9)]), ['N110…N210']);
  // The longer text reaches the next number.
  assert.deepEqual(texts([dot(110, 0), dot(130, 40), dot(120, 5)]), ['N110…N130']);
});

test('from the side a grid lies where it is seen', () => {
  const camera = new Camera();
  [camera.width, camera.height] = [600, 400];
  camera.look('XZ');
  const box: Box = { min: [0, 0, -30], max: [100, 80, 0] };
  camera.fit(box, [52, 48, 52, 48]);
  const { underlay } = grid(box, camera, LIGHT);
  assert.ok(underlay.points.every((point: Vector) => point[1] === underlay.points[0]![1]));
});

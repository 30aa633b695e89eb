// What the page shows of programs: colours, filters, what stays after a change.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, test } from 'node:test';

import { App } from '../src/app.ts';
import type { Container } from '../src/data/columns.ts';
import type { Header } from '../src/data/header.ts';
import { History } from '../src/data/history.ts';
import { Program } from '../src/data/program.ts';
import { type Legend, LIGHT, paint, rampCuts } from '../src/scene/colours.ts';
import { Lines } from '../src/scene/lines.ts';
import { pageData, program } from './pages.ts';

const folder = mkdtempSync(path.join(tmpdir(), 'cnc872c-'));
after(() => rmSync(folder, { recursive: true }));

async function dataOf(...blocks: string[]): Promise<Container<Header>> {
  const file = path.join(folder, 'part.nc');
  writeFileSync(file, `%5 "PART"\n${blocks.join('\n')}\n`);
  return (await pageData(file))!;
}

const LOOP = (times: number): string[] => [
  'N10 G17 G23 G90 G0 X0 Y0 Z0 S1000 M3',
  `N30 G71 L1 Q${times}`,
  'N40 G1 X50 Y50 F500',
  'N50 M30',
  'N100 G79 L1',
  'N110 G1 X10 Y0 F1000',
  'N120 X10 Y10',
  'N130 X0 Y10',
  'N140 X0 Y0',
  'N150 G70',
];

function painted(app: App, by: 'velocity' | 'tool' | 'feed'): { lines: Lines; legend: Legend } {
  const lines = new Lines(app.path, 0.01, undefined, by === 'velocity' ? rampCuts(app) : undefined);
  return { lines, legend: paint(app, lines, LIGHT, by) };
}

test('the next stop is that of `state`: M01 is one with optional stop only', async () => {
  const file = path.join(folder, 'stops.nc');
  writeFileSync(file, '%1\nN10 G90 G0 X0 Y0\nN20 M1\nN30 X5\nN40 M0\nN50 M30\n');
  for (const [options, stop] of [
    [[], 3],
    [['--optional-stop'], 1],
  ] as const) {
    const data = await pageData(file, ...options);
    const state = execFileSync(program, ['state', file, '--seq', '0', '--format', 'json', ...options]);
    assert.equal(JSON.parse(state.toString()).progress.next_stop, stop);
    assert.equal(new History(new Program(data!)).ahead(0).stop, stop);
  }
});

test('a pass in the middle of a loop is shown where it alone is chosen', async () => {
  const app = new App(await dataOf(...LOOP(6)));
  const executions = app.program.executionsAt(0, 7);
  assert.equal(executions.length, 6);
  const row = app.program.rowOf(executions[2]!);
  assert.equal(app.program.rowOf(executions[3]!), row, 'passes share their rows');
  app.filter.from = executions[2]!;
  app.filter.to = executions[2]! + 3;
  assert.equal(app.shownRows()[row], 1);
  assert.deepEqual(
    app.program.executionsOfRow(row).filter((index) => !app.isHidden(index)),
    [executions[2]],
  );
});

test('all executions of a block are together until another block is taken', async () => {
  const app = new App(
    await dataOf(
      'N10 G0 G90 G17 X0 Y0 Z0',
      'N20 G71 L1 Q4',
      'N30 M30',
      'N100 G79 L1',
      'N110 G91 G1 X10 F100',
      'N120 Y5',
      'N130 G70',
    ),
  );
  app.follow({ file: 0, line: 6 });
  assert.equal(app.together.length, 4);
  app.stepPass(1);
  assert.equal(app.together.length, 4);
  app.step(1);
  assert.equal(app.together.length, 0);
});

test('half a word takes no picture away', async () => {
  const app = new App(await dataOf(...LOOP(3)));
  app.follow({ file: 0, line: 8 });
  app.filter.from = 2;
  const { current, program } = app;
  const broken = await dataOf('N5 G0 X0 X1', ...LOOP(3));
  assert.equal(broken.header.count, 0);
  app.replace(broken, { file: 0, line: 8 });
  assert.deepEqual([app.stale, app.program === program, app.current], [true, true, current]);
  app.replace(await dataOf(...LOOP(4)), { file: 0, line: 1 });
  assert.deepEqual([app.stale, app.program === program], [false, false]);
  // The cursor stands at no block: what was in hand stays; and so does the chosen range, as long as the program is now.
  assert.equal(app.place(app.current!).line, 8);
  assert.deepEqual([app.filter.from, app.filter.to], [2, app.program.count - 1]);
});

test('a straight line shows how the velocity rises and falls', async () => {
  const app = new App(await dataOf('N10 G17 G90 G0 X0 Y0 Z0', 'N20 G24 G1 X100 F3000', 'N30 M30'));
  const { lines, legend } = painted(app, 'velocity');
  const [first, count] = lines.chordsOf(app.program.rowOf(1));
  assert.ok(count >= 3);
  const colours = [...lines.colours.slice(2 * first, 2 * (first + count))];
  assert.equal(colours[0], colours[colours.length - 1], 'at rest at both ends');
  assert.ok(new Set(colours).size > 3);
  const longest = Array.from({ length: count }, (_, i) => first + i).reduce((best, chord) =>
    lines.points[6 * chord + 3]! - lines.points[6 * chord]! > lines.points[6 * best + 3]! - lines.points[6 * best]!
      ? chord
      : best,
  );
  assert.equal(lines.colours[2 * longest], lines.colours[2 * longest + 1], 'constant between');
  assert.notEqual(lines.colours[2 * longest], colours[0]);
  assert.deepEqual(legend.kind === 'scale' && legend.scales.map(({ to, unit }) => [to, unit]), [[3000, 'mm/min']]);
});

test('every tool looks different', async () => {
  const tools = Array.from({ length: 30 }, (_, i) => [
    `N${100 * (i + 1)} T${i + 1} M6`,
    `N${100 * (i + 1) + 10} G1 X${(i % 2) * 50} Y${i} F100`,
  ]);
  const app = new App(await dataOf('N10 G17 G90 G0 X0 Y0 Z0 S100 M3', ...tools.flat(), 'N9000 M30'));
  const { lines, legend } = painted(app, 'tool');
  assert.ok(legend.kind === 'names');
  const looks = legend.items.filter((item) => item.name.startsWith('T')).map(({ colour, dash }) => `${colour} ${dash}`);
  assert.ok(looks.length >= 29);
  assert.equal(new Set(looks).size, looks.length);
  for (let chord = 0; chord < lines.count; chord += 1) {
    assert.ok(looks.includes(`${lines.colours[2 * chord]} ${lines.dash(chord)}`), 'the legend has what is drawn');
  }
});

test('feeds that count different things have scales of their own', async () => {
  const app = new App(
    await dataOf(
      'N10 G17 G90 G0 X0 Y0 Z0 S100 M3',
      'N20 G94 G1 X10 F100',
      'N30 X20 F400',
      'N40 G95 X30 F.06',
      'N50 X40 F.3',
      'N60 M30',
    ),
  );
  const { legend } = painted(app, 'feed');
  assert.deepEqual(legend, {
    kind: 'scale',
    scales: [
      { from: 100, to: 400, unit: 'mm/min' },
      { from: 0.06, to: 0.3, unit: 'mm/rev' },
    ],
  });
});

test('motion of rotary axes alone is degrees a minute; without working motion there is no box of it', async () => {
  writeFileSync(
    path.join(folder, 'cnc872c.toml'),
    `${[...'XYZ'].map((letter) => `[[axes]]\nletter="${letter}"\nkind="linear"\n`).join('')}[[axes]]\nletter="C"\nkind="rotary"\n`,
  );
  try {
    const app = new App(await dataOf('N10 G17 G90 G0 X0 Y0 Z0 C0', 'N20 G0 X5 Y5', 'N30 C90', 'N40 X8 C95', 'N50 M30'));
    assert.deepEqual(
      [0, 1, 2, 3].map((index) => app.program.turns(app.program.rowOf(index))),
      [false, false, true, false],
    );
    assert.equal(app.path.workingBox, undefined);
  } finally {
    rmSync(path.join(folder, 'cnc872c.toml'));
  }
});

// Velocities, joints and times that a page gives are those of the motion stream, whatever the feeds.

import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';

import type { Fields, Json } from '../src/data/header.ts';
import { Program } from '../src/data/program.ts';
import { Times } from '../src/data/times.ts';
import { pageData, root, samples, stream } from './pages.ts';

const FEEDS = ['programmed', 'cap', 'start', 'peak', 'end', 'feed'];

function same(shown: Json | undefined, value: Json, name: string, where: string): void {
  if (typeof value !== 'number') {
    assert.deepEqual(shown, value, where);
    return;
  }
  const slack = FEEDS.includes(name)
    ? Math.max(1e-3, 1e-6 * Math.abs(value))
    : name.endsWith('_s')
      ? 1e-3
      : name === 'angle_deg'
        ? 0.01
        : 1e-6;
  assert.ok(Math.abs((shown as number) - value) <= slack, `${where}: ${String(shown)}, not ${value}`);
}

async function timesOf(file: string): Promise<{ program: Program; times: Times; records: Fields[] } | undefined> {
  const records = stream('motion', file, '--format', 'json');
  const data = records === undefined || records.length > 50_000 ? undefined : await pageData(file);
  if (records === undefined || data === undefined) {
    return undefined;
  }
  const program = new Program(data);
  return { program, times: new Times(data, program), records };
}

async function check(file: string): Promise<void> {
  const found = await timesOf(file);
  if (found === undefined) {
    return;
  }
  const { times, records } = found;
  sameRecords(times, records);
  // A page of a part, which may begin and end within a stretch.
  const third = Math.floor(records.length / 3);
  for (const [from, count] of [
    [0, third],
    [third, third],
  ] as const) {
    const data = count === 0 ? undefined : await pageData(file, '--from', String(from), '--blocks', String(count));
    if (data !== undefined) {
      sameRecords(new Times(data, new Program(data)), records.slice(from, from + count));
    }
  }
}

function sameRecords(times: Times, records: Fields[]): void {
  records.forEach((record, index) => {
    const shown = times.record(index);
    const { kind: _, seq, n: __, file: ___, line: ____, joint, ...fields } = record as { [name: string]: Json };
    for (const [name, value] of Object.entries(fields)) {
      same(shown[name], value, name, `${String(seq)} ${name}`);
    }
    for (const [name, value] of Object.entries((joint ?? {}) as Fields)) {
      same((shown['joint'] as Fields | undefined)?.[name], value, name, `${String(seq)} joint.${name}`);
    }
    const feed = (joint as Fields | undefined)?.['feed'];
    if (typeof feed === 'number') {
      assert.ok(times.jointCap(index)! >= feed - 1e-3, `${String(seq)}: no joint is passed faster than its cap`);
    }
  });
}

for (const file of samples().filter((file) => !file.includes('samples/rules'))) {
  test(path.relative(root, file), () => check(file));
}

/** A program in a folder of its own, with its project file. */
async function written(program: string, project: string, run: (file: string) => Promise<void>): Promise<void> {
  const folder = mkdtempSync(path.join(tmpdir(), 'cnc872c-'));
  try {
    writeFileSync(path.join(folder, 'part.nc'), program);
    writeFileSync(path.join(folder, 'cnc872c.toml'), project);
    await run(path.join(folder, 'part.nc'));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('the greatest feeds', () =>
  written(
    '%1\nN10 G0 G90 G23 G17 X0 Y0 Z0 S9999 M3\nN20 G1 X1000 F15000\nN30 G95 X9000 F99\nN40 X9000 Y9000\nN50 X0\nN60 M30\n',
    '[motion]\naccel-mm-s2 = 100000\naccel-continuous-mm-s2 = 100000\n',
    async (file) => {
      const records = stream('motion', file, '--format', 'json');
      assert.ok(
        records!.some((record) => (record['programmed'] as number) > 5e5),
        'in parts of a mm/min more than 32 bits hold',
      );
      await check(file);
    },
  ));

test('a page that ends within a joined piece', () =>
  written(
    `%1\nN10 G0 X0 Y0 Z0 G23\nN20 G1 X10 F1000\n${Array.from({ length: 40 }, (_, at) => `N${30 + at} X${10.5 + at / 2}`).join('\n')}\nN80 M30\n`,
    '[motion]\nmerge-length-mm = 2\n',
    check,
  ));

test('the cap of a joint is that of accuracy where a ramp leads to it', () =>
  written(
    '%1\nN10 G0 G90 G17 X0 Y0 Z0\nN20 G23 G1 X10 F3000\nN30 X110 Y20\nN40 X200\nN50 M30\n',
    '[motion]\nprofile = "linear"\ncycle-ms = 4\naccuracy-um = 10\naccel-continuous-mm-s2 = 20\n',
    async (file) => {
      const { program, times } = (await timesOf(file))!;
      const joints = Array.from({ length: program.count }, (_, index) => times.joint(index));
      const ramp = joints.findIndex((joint) => joint?.limited_by === 'ramp');
      const { feed, angle_deg: angle } = joints[ramp]!;
      const accuracy = (10 / (4 * Math.tan((angle! * Math.PI) / 360))) * 60;
      assert.ok(feed < times.jointCap(ramp)!);
      assert.ok(Math.abs(times.jointCap(ramp)! - Math.min(accuracy, 3000)) < 0.1);
    },
  ));

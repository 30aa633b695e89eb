// How far the axes reach, as the set-up sheet says it.

import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';

import type { Size } from '../src/data/header.ts';
import { pageData, report, root, samples } from './pages.ts';

type Extents = { [letter: string]: [number, number] } & { lower_bound_axes?: string[] };

function same({ axes, lacks }: Size, extents: Extents, twice: boolean, where: string): void {
  const letters = ['X', 'Y', 'Z'];
  const farther = letters.filter((letter) => extents.lower_bound_axes?.includes(letter) === true);
  assert.equal(lacks, farther.join(''), where);
  assert.deepEqual(
    Object.keys(axes).sort(),
    letters.filter((letter) => letter in extents),
    where,
  );
  for (const [letter, known] of Object.entries(axes)) {
    const expected = extents[letter]!;
    const times = letter === 'X' && twice ? 2 : 1;
    const apart = known.map((value, end) => Math.abs(times * value - expected[end]!));
    assert.ok(Math.max(...apart) < 1e-6, `${where} ${letter}: ${known.join(' to ')}, not ${expected.join(' to ')}`);
  }
}

async function check(file: string): Promise<void> {
  const sheet = report(file);
  const data = sheet === undefined ? undefined : await pageData(file);
  if (sheet === undefined || data?.header.whole !== true || data.header.count !== data.header.blocks) {
    return;
  }
  const { working, all } = sheet['extents'] as unknown as { working: Extents; all: Extents };
  const { size } = data.header;
  same(size.working, working, sheet['diameter'] === true, 'working');
  same(size.all, all, sheet['diameter'] === true, 'all');
}

for (const file of samples()) {
  test(path.relative(root, file), () => check(file));
}

test('motions without a line, and cycles that nobody knows', async () => {
  const folder = mkdtempSync(path.join(tmpdir(), 'cnc872c-'));
  try {
    const file = path.join(folder, 'part.nc');
    const programs = {
      macrocycle: 'N1 G0 X0 Y0 Z0\nN2 G1 X10 F100\nN3 G72 L9001\nN4 G1 X50 Y5\nN5 Z3',
      cycle: 'N1 G0 X0 Y0 Z9\nN2 G1 X10 F100\nN3 G81 X50 Y5\nN4 G80',
      arc: 'N1 G0 X0 Y0 Z0 F100\nN2 G3 X-3000 Y4000 I-3000 J-4000\nN3 G2 X-3000 Y4000 I0 J-4000',
    };
    writeFileSync(path.join(folder, 'cnc872c.toml'), '[machine-macrocycles]\nL9001 = {}\n');
    for (const program of Object.values(programs)) {
      writeFileSync(file, `%1\n${program}\nN9 M30\n`);
      await check(file);
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});

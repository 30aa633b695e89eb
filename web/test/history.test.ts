// What the panel tells behind a block is what `cnc872c state --after` says, for places in every sample.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import path from 'node:path';
import { test } from 'node:test';

import type { Fields } from '../src/data/header.ts';
import { History } from '../src/data/history.ts';
import { Program } from '../src/data/program.ts';
import { Times } from '../src/data/times.ts';
import { pageData, program as cnc872c, root, samples } from './pages.ts';

/** Places in a program of so many executed blocks: the first ones, the last ones, some between. */
function places(count: number): number[] {
  const between = Array.from({ length: 5 }, (_, part) => Math.floor((count * (part + 1)) / 6));
  const all = [0, 1, 2, ...between, count - 3, count - 2, count - 1];
  return [...new Set(all)].filter((index) => index >= 0 && index < count);
}

const near = (left: unknown, right: number, by: number, what: string): void =>
  assert.ok(Math.abs((left as number) - right) <= by, `${what}: ${String(left)}, ${right}`);

for (const file of samples()) {
  test(path.relative(root, file), async () => {
    const data = await pageData(file);
    if (data === undefined || !data.header.whole || data.header.count > 100_000) {
      return;
    }
    const program = new Program(data);
    const history = new History(program);
    const times = new Times(data, program);
    for (const index of places(program.count)) {
      const asked = ['state', file, '--seq', String(index), '--after', '--format', 'json'];
      const state = JSON.parse(execFileSync(cnc872c, asked, { stdio: ['ignore', 'pipe', 'ignore'] }).toString()) as {
        [name: string]: Fields;
      } & { counters: Fields[] };
      const written = Object.entries(state['written']!).map(([name, writer]) => [name, (writer as Fields)['seq']]);
      const writer = history.writers(index);
      const told = written.map(([name]) => [name, writer(name as string)]);
      assert.deepEqual(told, written, `written, seq ${index}`);
      assert.deepEqual(program.heldBehind(index), state['g'], `g, seq ${index}`);
      const row = program.rowOf(index);
      const why = program.shapeOf(row).w ?? {};
      const unknown = program.letters
        .filter((letter, axis) => history.moves(letter) && (letter in why || !program.isKnown(row, axis)))
        .map((letter) => [letter, why[letter] ?? 'not_programmed']);
      assert.deepEqual(Object.fromEntries(unknown), state['unknown'], `unknown, seq ${index}`);
      const known = history.parameters(writer).map(([name, value]) => [name, value]);
      assert.deepEqual(Object.fromEntries(known), state['parameters'], `parameters, seq ${index}`);
      const counters = history.counters(index).map((counter) => {
        const block = program.block[program.rowOf(counter.index)]!;
        return [program.fileOf(block), program.line[block], counter.left, counter.of];
      });
      const armed = state.counters.map(({ file: at, line, left, of }) => [at, line, left, of]);
      assert.deepEqual(counters, armed, `counters, seq ${index}`);
      const { blocks_left, path_mm, path_left_mm, time_s, time_left_s, next_tool_change, next_stop } =
        state['progress']!;
      const done = history.pathBefore(index + 1);
      assert.equal(program.count - index - 1, blocks_left);
      near(path_mm, done, 2e-6 * (index + 2), `path, seq ${index}`);
      near(path_left_mm, history.path - done, 2e-6 * program.count, `path left, seq ${index}`);
      if (time_s !== undefined) {
        near(time_s, times.startOf(index + 1), 1e-4 + 1e-8 * index, `time, seq ${index}`);
        near(
          time_left_s,
          (data.header.total!['time_s'] as number) - times.startOf(index + 1),
          1e-4 + 1e-8 * program.count,
          `left, ${index}`,
        );
      }
      const { tool, stop } = history.ahead(index);
      assert.deepEqual([tool, stop], [next_tool_change, next_stop], `ahead, seq ${index}`);
    }
  });
}

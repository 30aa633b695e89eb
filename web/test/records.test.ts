// Every record that a page gives is that of the block stream, for every sample; so is every text.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';

import { Program } from '../src/data/program.ts';
import { Text } from '../src/data/text.ts';
import { pageData, root, samples, stream } from './pages.ts';

for (const file of samples()) {
  test(path.relative(root, file), async () => {
    const records = stream('compile', file);
    if (records === undefined || records.length > 100_000) {
      return;
    }
    const data = await pageData(file);
    assert.ok(data !== undefined);
    const program = new Program(data);
    const text = new Text(data, program);
    assert.equal(program.count, records.length);
    assert.equal(data.header.blocks, records.length);
    for (let index = 0; index < records.length; index += 1) {
      assert.deepEqual(program.record(index), records[index]);
    }
    const written = readFileSync(file);
    if (written.every((byte) => byte < 128)) {
      const lines = written.toString('utf8').split(/\r\n|\r|\n/);
      assert.equal(text.lines[0], lines.length);
      lines.forEach((line, at) => {
        const pieces = text.line(0, at + 1).map((piece) => piece.text);
        assert.equal(pieces.join(''), line);
      });
    }
  });
}

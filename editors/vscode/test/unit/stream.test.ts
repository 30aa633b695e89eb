// The view of the block stream.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { asStream, blocks, signalsPath, viewPath } from '../../src/stream';

test('answers of the server', () => {
  assert.deepEqual(asStream({ text: '{}', truncated: true }), { text: '{}', truncated: true });
  assert.deepEqual(asStream({ text: '' }), { text: '', truncated: false });
  for (const wrong of [null, undefined, 'text', 5, {}, { text: 5 }]) {
    assert.equal(asStream(wrong), undefined);
  }
});

test('records are counted', () => {
  assert.equal(blocks('{"kind":"program"}\n{"kind":"block","seq":1}\n{"kind": "block","seq":2}\n{"kind":"end"}\n'), 2);
  assert.equal(blocks(''), 0);
});

test('names of views', () => {
  assert.equal(viewPath('/programs/flange.nc'), '/flange.nc.jsonl');
  assert.equal(viewPath('C:\\programs\\L9001'), '/L9001.jsonl');
  assert.equal(viewPath('Untitled-1'), '/Untitled-1.jsonl');
  assert.equal(viewPath(''), '/program.jsonl');
  assert.equal(signalsPath('/programs/flange.nc'), '/flange.nc.plc.txt');
});

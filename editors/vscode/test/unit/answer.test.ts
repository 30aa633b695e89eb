// Questions about a place.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { asPlaceAnswer, statePath } from '../../src/answer';

test('answers about a place', () => {
  assert.deepEqual(asPlaceAnswer(null), { kind: 'nothing' });
  assert.deepEqual(asPlaceAnswer({ seq: 3, text: 'a', state: {} }), { kind: 'text', text: 'a', message: undefined });
  assert.deepEqual(asPlaceAnswer({ text: '%1', message: 'm' }), { kind: 'text', text: '%1', message: 'm' });
  const pass = { pass: 1, seq: 5, text: 'N60' };
  assert.deepEqual(asPlaceAnswer({ count: 7, message: 'which?', passes: [pass, { pass: 2 }] }), {
    kind: 'passes',
    message: 'which?',
    count: 7,
    passes: [pass],
  });
  assert.deepEqual(asPlaceAnswer({ safe: 'how high?' }), { kind: 'safe', message: 'how high?' });
  assert.deepEqual(asPlaceAnswer({ refused: 'no', nearest: { seq: 1, n: 20 } }), {
    kind: 'refused',
    message: 'no',
    nearest: { seq: 1, n: 20 },
  });
  assert.deepEqual(asPlaceAnswer({ refused: 'no', nearest: null }), {
    kind: 'refused',
    message: 'no',
    nearest: undefined,
  });
  for (const wrong of [undefined, 'text', 5, {}, { text: 5 }, { passes: [] }]) {
    assert.equal(asPlaceAnswer(wrong), undefined);
  }
});

test('names of views of states', () => {
  assert.equal(statePath('/programs/flange.nc'), '/flange.nc.state.txt');
  assert.equal(statePath('C:\\programs\\L9001'), '/L9001.state.txt');
});

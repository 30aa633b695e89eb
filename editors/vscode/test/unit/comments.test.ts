// Switching blocks off and on again.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { isOff, switchOff, switchOn, toggle } from '../../src/comments';

test('a block with a comment becomes one comment', () => {
  assert.equal(switchOff('N20  T1 M06   "Freza D16"'), `"// N20  T1 M06   'Freza D16'"`);
});

test('every line comes back as it was', () => {
  for (const line of ['N10 G0 X1', '  N20 "a" X1 "b', `N30 "it's ^ 5'"`, '"Titul"', 'N40 X1 \t', `"// off"`, "''^^'"]) {
    const off = switchOff(line);
    assert.ok(isOff(off), off);
    assert.equal(switchOn(off), line);
  }
});

test('a comment of the program is not taken for a block', () => {
  assert.ok(!isOff('"Freza"'));
  assert.ok(!isOff('"// N10" X5 "b"'));
});

test('each line of a selection', () => {
  const lines = ['N10 X1', '', 'N20 X2 "c"'];
  const off = toggle(lines);
  assert.deepEqual(off, ['"// N10 X1"', '', `"// N20 X2 'c'"`]);
  assert.deepEqual(toggle(off), lines);
  assert.deepEqual(toggle([off[0] ?? '', 'N20 X2']), [`"// '// N10 X1'"`, '"// N20 X2"']);
});

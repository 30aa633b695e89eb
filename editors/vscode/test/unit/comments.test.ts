// Switching blocks off and on again.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { continues, isOff, switchOff, switchOn, toggle } from '../../src/comments';

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

test('no line gets longer than 80 characters (LEX-7)', () => {
  const long = [
    'N10 G01 X1.125 Y2.250 Z3.375 F1000 S2000 M03 M08 "hrubovani kapsy, posledni T7"',
    `N20 "${"'^".repeat(37)}`,
  ];
  for (const line of [...long, `N30 X1  "${'x'.repeat(71)}"`, `N40 "${'ž'.repeat(73)}  `]) {
    const off = switchOff(line).split('\n');
    assert.ok(off.length > 1, line);
    for (const [at, part] of off.entries()) {
      assert.ok(isOff(part) && part.length <= 80, part);
      assert.equal(continues(part), at > 0);
    }
    const on = toggle(off);
    assert.deepEqual(on, [line.trimEnd(), ...off.slice(1).map(() => undefined)]);
  }
  assert.deepEqual(switchOff(long[0] ?? '').split('\n'), [
    `"// N10 G01 X1.125 Y2.250 Z3.375 F1000 S2000 M03 M08 'hrubovani kapsy, "`,
    `"//+ posledni T7'"`,
  ]);
});

test('a rest whose beginning is not chosen stays a line', () => {
  assert.deepEqual(toggle(['"// N10 "', '"//+ X1"'], [3, 7]), ['N10 ', 'X1']);
});

// Which findings are offered for an explanation.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { type Finding, asCode, choices, pageOf } from '../../src/findings';

function finding(code: Finding['code'], line: number, from: number, to: number, message = 'said'): Finding {
  return { code, message, range: { start: { line, character: from }, end: { line, character: to } } };
}

test('codes', () => {
  assert.equal(asCode(' e0306 '), 'E0306');
  assert.equal(asCode('W0214'), 'W0214');
  for (const wrong of ['', 'E306', 'G73', 'E03061', 'X0306']) {
    assert.equal(asCode(wrong), undefined, wrong);
  }
});

test('the finding at the cursor comes first, then its line, then the rest, each code once', () => {
  const findings = [
    finding('E0101', 1, 0, 5),
    finding({ value: 'E0306', target: undefined }, 4, 20, 23),
    finding('W0214', 4, 0, 3, 'first line\nsecond'),
    finding('W0214', 9, 0, 3),
    finding('E0104', 7, 0, 2),
    finding(undefined, 4, 0, 3),
    finding('other', 4, 0, 3),
  ];
  assert.deepEqual(choices(findings, { line: 4, character: 3 }), [
    { code: 'W0214', message: 'first line', here: true },
    { code: 'E0306', message: 'said', here: false },
    { code: 'E0101', message: 'said', here: false },
    { code: 'E0104', message: 'said', here: false },
  ]);
  assert.deepEqual(choices([], { line: 0, character: 0 }), []);
});

test('pages', () => {
  assert.equal(pageOf('E0307', 'cs'), 'cnc872c:/explain/cs/E0307.md');
});

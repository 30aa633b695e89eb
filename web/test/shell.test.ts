// What somebody copies into a terminal is one argument there, and nothing else.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { test } from 'node:test';

import { quoted } from '../src/data/shell.ts';

test('arguments are quoted for shells', () => {
  assert.equal(quoted('mill/part-2.nc'), 'mill/part-2.nc');
  assert.equal(quoted('R10=-1.5'), 'R10=-1.5');
  assert.equal(quoted('příruba 2.nc'), '"příruba 2.nc"');
  const names = [
    'a$(touch pwned).nc',
    '`id`',
    '"',
    "'",
    `x'<b>&"\${a}žl\`.nc`,
    'a\\',
    '$HOME',
    'a;b',
    '!!',
    '*',
    '~',
    '(a)',
  ];
  for (const name of names) {
    assert.equal(execFileSync('/bin/sh', ['-c', `printf %s ${quoted(name)}`], { encoding: 'utf8' }), name);
  }
});

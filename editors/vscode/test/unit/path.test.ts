// The panel with the path: what the server and the page say, and what the page may do.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { asPath, asSelected, pageOf } from '../../src/path';

test('answers of the server', () => {
  const path = asPath({ uri: 'file:///a.nc', files: ['file:///a.nc', null], blocks: 5, truncated: true, data: 'AQI=' });
  assert.deepEqual(path, {
    uri: 'file:///a.nc',
    files: ['file:///a.nc', undefined],
    blocks: 5,
    truncated: true,
    data: new Uint8Array([1, 2]),
  });
  for (const wrong of [null, undefined, 'text', {}, { uri: 'a', files: [] }, { uri: 'a', files: 'b', data: '' }]) {
    assert.equal(asPath(wrong), undefined);
  }
});

test('what the page says', () => {
  assert.deepEqual(asSelected({ cnc872c: 'select', detail: { seq: 7, file: 1, line: 12 } }), { file: 1, line: 12 });
  for (const wrong of [
    null,
    {},
    { cnc872c: 'ready' },
    { cnc872c: 'select' },
    { cnc872c: 'select', detail: { file: 'x' } },
  ]) {
    assert.equal(asSelected(wrong), undefined);
  }
});

test('nothing but the viewer runs in the page, and nothing is fetched', () => {
  const page = pageOf({ script: 'v:/viewer.js', styles: 'v:/viewer.css', source: 'v:' }, 'abc', 'cs');
  const policy = /Content-Security-Policy" content="([^"]*)"/.exec(page)?.[1] ?? '';
  assert.deepEqual(policy.split('; '), [
    "default-src 'none'",
    "script-src 'nonce-abc'",
    "style-src v: 'unsafe-inline'",
    'img-src data: blob:',
  ]);
  assert.equal(page.match(/<script/g)?.length, 1);
  assert.match(page, /<script nonce="abc" src="v:\/viewer.js">/);
  assert.match(page, /data-lang="cs"/);
});

// What the server is told of the settings.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import manifest from '../../package.json';
import { SERVER_SETTINGS, language, serverSettings } from '../../src/settings';

test('what is not set is null', () => {
  const unset = serverSettings(() => undefined);
  assert.deepEqual(Object.keys(unset), [...SERVER_SETTINGS.slice(0, -1), 'limits']);
  assert.deepEqual(unset['limits'], { records: null });
  assert.ok(Object.values(unset).every((value) => value === null || typeof value === 'object'));
  const empty: Record<string, unknown> = { macrocycles: [], parameters: {}, dialect: '', lints: {} };
  assert.deepEqual(
    serverSettings((name) => empty[name]),
    unset,
  );
});

test('what is set goes through as it is', () => {
  const values: Record<string, unknown> = {
    language: 'cs',
    dialect: 'cnc8x6',
    macrocycles: ['macros', '../common'],
    parameters: { R1: 5, R10: 25.5 },
    'block-skip': false,
    lints: { W0214: 'allow' },
    'limits.records': 1000,
  };
  const settings = serverSettings((name) => values[name]);
  assert.deepEqual(settings, {
    language: 'cs',
    dialect: 'cnc8x6',
    'channel-config': null,
    macrocycles: ['macros', '../common'],
    parameters: { R1: 5, R10: 25.5 },
    'block-skip': false,
    'optional-stop': null,
    encoding: null,
    lints: { W0214: 'allow' },
    limits: { records: 1000 },
  });
});

test('every setting of the server can be made, and none but language has a value of its own', () => {
  const properties: Record<string, { default?: unknown }> = manifest.contributes.configuration.properties;
  for (const name of SERVER_SETTINGS) {
    const property = properties[`cnc872c.${name}`];
    assert.ok(property, name);
    assert.equal(property.default, name === 'language' ? 'auto' : null, name);
  }
});

test('the language of pages', () => {
  assert.equal(language('auto', 'cs'), 'cs');
  assert.equal(language('auto', 'cs-CZ'), 'cs');
  assert.equal(language('auto', 'en-US'), 'en');
  assert.equal(language('auto', 'csb'), 'en');
  assert.equal(language('en', 'cs'), 'en');
  assert.equal(language('cs', 'de'), 'cs');
});

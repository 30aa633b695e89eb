// Whatever the records name stands on the page in both languages.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';

import { type Key, named, setLanguage, t } from '../src/i18n.ts';
import { root } from './pages.ts';

/** The names that a field of a form may have, by its schema. */
function names(field: string, schema = 'motion'): string[] {
  const found: string[] = [];
  const walk = (value: unknown): void => {
    if (typeof value === 'object' && value !== null) {
      for (const [name, inner] of Object.entries(value)) {
        const listed = (inner as { enum?: string[] } | null)?.enum;
        found.push(...(name === field && listed !== undefined ? listed : []));
        walk(inner);
      }
    }
  };
  walk(JSON.parse(readFileSync(path.join(root, `docs/reference/generated/schemas/${schema}.json`), 'utf8')));
  return found;
}

for (const field of ['broken_by', 'limited_by', 'cap_by']) {
  test(`every ${field} has a text`, () => {
    assert.ok(names(field).length > 3);
    for (const name of names(field)) {
      setLanguage('en');
      const english = named(name);
      setLanguage('cs');
      const czech = named(name);
      // G00 is itself in every language.
      const differ = english !== czech || english === 'G00';
      assert.ok(!english.includes('_') && !czech.includes('_') && differ, `${name}: ${english}, ${czech}`);
    }
  });
}

test('every reason why a position is not known has a text', () => {
  const reasons = names('additionalProperties', 'state');
  assert.ok(reasons.includes('macrocycle') && reasons.length > 7);
  for (const reason of reasons) {
    const texts = (['en', 'cs'] as const).map((lang) => {
      setLanguage(lang);
      return t(`unknown_${reason}` as Key);
    });
    assert.ok(texts.every((text) => text.length > 5) && texts[0] !== texts[1], reason);
  }
});

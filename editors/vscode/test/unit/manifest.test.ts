// package.json and its texts: names that must fit together, both languages complete.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { test } from 'node:test';

import languageConfiguration from '../../language-configuration.json';
import bundle from '../../l10n/bundle.l10n.cs.json';
import manifest from '../../package.json';
import czech from '../../package.nls.cs.json';
import english from '../../package.nls.json';

const sources = readdirSync('src').map((file) => readFileSync(`src/${file}`, 'utf8'));

test('texts of the manifest are all there, in both languages, and all are used', () => {
  const used = [...JSON.stringify(manifest).matchAll(/"%([^%"]+)%"/g)].map(([, key]) => key as string);
  assert.deepEqual(Object.keys(czech).sort(), Object.keys(english).sort());
  assert.deepEqual([...new Set(used)].sort(), Object.keys(english).sort());
});

test('texts of the code are all there in Czech, and all are used', () => {
  const used = sources.flatMap((source) =>
    [...source.matchAll(/l10n\s*\.t\(\s*('(?:[^'\\]|\\.)*')/g)].map(([, text]) => (text as string).slice(1, -1)),
  );
  assert.ok(used.length > 10);
  assert.deepEqual([...new Set(used)].sort(), Object.keys(bundle).sort());
  const places = (text: string) => (text.match(/\{\d\}/g) ?? []).sort().join();
  for (const [key, text] of Object.entries(bundle)) {
    assert.equal(places(text), places(key), key);
  }
});

test('commands of the manifest are registered', () => {
  const registered = sources.join('\n');
  for (const { command } of manifest.contributes.commands) {
    assert.ok(registered.includes(`'${command}':`), command);
  }
});

test('files of the manifest exist', () => {
  const { languages, grammars, snippets } = manifest.contributes;
  const files = [
    manifest.icon,
    ...languages.flatMap(({ configuration, icon }) => [configuration, ...(icon ? [icon.light, icon.dark] : [])]),
    ...grammars.map((grammar) => grammar.path),
    ...snippets.map((snippet) => snippet.path),
  ];
  assert.deepEqual(
    files.filter((file) => !existsSync(file)),
    [],
  );
});

test('first lines of programs and macrocycles', () => {
  const first = new RegExp(manifest.contributes.languages[0]?.firstLine ?? '');
  for (const line of ['%1', '%306 "two targets"', '  % 42', '%', 'N10 G79 L9001', 'n1g079', ' N 1  G79 L5']) {
    assert.equal(first.test(line), !line.includes('g079'), line);
  }
  for (const line of [
    '%PDF-1.7',
    '%!PS-Adobe-3.0',
    '% a comment of TeX',
    'N10 G0 X0',
    'N10 G790',
    '"drawing"',
    '#!/bin/sh',
  ]) {
    assert.ok(!first.test(line), line);
  }
});

test('words', () => {
  const { pattern, flags } = languageConfiguration.wordPattern;
  const words = (line: string) => line.match(new RegExp(pattern, `g${flags}`));
  assert.deepEqual(words('N100 G01 X-12.5 Y.5 R10=-3 XR10'), ['N100', 'G01', 'X-12.5', 'Y.5', 'R10', '-3', 'XR10']);
  assert.deepEqual(words('N10G2X5Y-R1&0012/M01'), ['N10', 'G2', 'X5', 'Y-R1', '&0012', 'M01']);
  assert.deepEqual(words('%306 "najezd po oblouku"'), ['%306', 'najezd', 'po', 'oblouku']);
  assert.deepEqual(words('"Příruba, díra"'), ['Příruba', 'díra']);
});

test('names of macrocycles', () => {
  const patterns = manifest.contributes.languages[0]?.filenamePatterns ?? [];
  const expressions = patterns.map((pattern) => new RegExp(`^${pattern.replaceAll('.', '\\.')}$`));
  const matches = (name: string) => expressions.some((expression) => expression.test(name));
  for (const name of ['L1', 'L9001', 'l9001', 'L09001', 'L9001.txt', 'l9001.TXT']) {
    assert.ok(matches(name), name);
  }
  for (const name of ['l10n.ts', 'L10N.md', 'L2-norm.py', 'L', 'LICENSE', 'L9001.json']) {
    assert.ok(!matches(name), name);
  }
});

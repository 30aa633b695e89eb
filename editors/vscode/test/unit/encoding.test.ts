// The machines' code pages: what the settings of package.json make of real programs. Reading and guessing are done by the
// libraries that the editor uses, in their versions, called as the editor calls them.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';

import * as iconv from '@vscode/iconv-lite-umd';
import * as jschardet from 'jschardet';

import manifest from '../../package.json';
import { CODE_PAGES, again, isDamaged } from '../../src/encoding';

const defaults = manifest.contributes.configurationDefaults['[cnc872]'];
const samples = path.resolve('../../samples');

/** Every program of the samples. */
const programs = readdirSync(samples, { recursive: true, encoding: 'utf8' }).filter((file) =>
  /(?:\.(?:nc|ncp|mrc)|[/\\]L\d+)$/i.test(file),
);

/** The encoding in which the editor opens a file: UTF-8 if that is recognised, else the one of the settings. */
function openedAs(bytes: Buffer): string {
  assert.equal(defaults['files.autoGuessEncoding'], true);
  assert.deepEqual(defaults['files.candidateGuessEncodings'], ['utf8']);
  const guessed = jschardet.detect(bytes.toString('latin1'), { detectEncodings: ['UTF-8'] });
  return guessed?.encoding === 'UTF-8' ? 'utf8' : defaults['files.encoding'];
}

function isUtf8(bytes: Buffer): boolean {
  return Buffer.from(bytes.toString('utf8'), 'utf8').equals(bytes);
}

test('every byte survives reading and writing as CP852', () => {
  const all = Buffer.from(Array.from({ length: 256 }, (_, byte) => byte));
  assert.ok(all.equals(iconv.encode(iconv.decode(all, 'cp852'), 'cp852')));
});

test('saving an opened sample gives the same bytes', () => {
  assert.ok(programs.length > 100);
  for (const program of programs) {
    const bytes = readFileSync(path.join(samples, program));
    const encoding = openedAs(bytes);
    const text = iconv.decode(bytes, encoding, { stripBOM: false });
    if (isUtf8(bytes) || encoding !== 'utf8') {
      assert.ok(bytes.equals(iconv.encode(text, encoding)), program);
      assert.equal(isDamaged(text), text.includes('\uFFFD'), program);
    }
  }
});

test('samples open as what they are', () => {
  for (const program of programs) {
    const bytes = readFileSync(path.join(samples, program));
    const ascii = bytes.every((byte) => byte < 0x80);
    if (!ascii) {
      assert.equal(openedAs(bytes), isUtf8(bytes) ? 'utf8' : 'cp852', program);
    }
  }
});

test('Czech comments in each code page', () => {
  const text = '%1 "Příliš žluťoučký kůň úpěl ďábelské ódy"\r\nN10 M30\r\n';
  for (const { id } of [...CODE_PAGES, { id: 'utf8' }]) {
    const bytes = Buffer.from(iconv.encode(text, id));
    assert.equal(iconv.decode(bytes, id), text);
    const encoding = openedAs(bytes);
    assert.equal(encoding, id === 'utf8' ? 'utf8' : 'cp852', id);
    assert.ok(bytes.equals(iconv.encode(iconv.decode(bytes, encoding), encoding)), id);
  }
});

test('one Czech letter is enough', () => {
  for (const letter of 'áčďéěíňóřšťúůýžÁČĎÉĚÍŇÓŘŠŤÚŮÝŽ') {
    const text = `%1 "${letter}"\r\n`;
    assert.equal(openedAs(Buffer.from(text)), 'utf8', letter);
    assert.equal(openedAs(Buffer.from(iconv.encode(text, 'cp852'))), 'cp852', letter);
  }
});

test('a program of another code page that was read as UTF-8 is damaged', () => {
  for (const { id } of CODE_PAGES) {
    assert.ok(isDamaged(iconv.decode(iconv.encode('"kůň"', id), 'utf8')), id);
  }
  assert.ok(!isDamaged('%1 "kůň"'));
});

test('what is read again without asking', () => {
  assert.equal(again(defaults['files.encoding'], 'utf8'), 'cp852');
  assert.equal(again('windows1250', 'utf8'), 'windows1250');
  assert.equal(again('cp852', 'cp852'), undefined);
  assert.equal(again('utf8', 'utf8'), undefined);
  assert.equal(again(undefined, 'utf8'), undefined);
});

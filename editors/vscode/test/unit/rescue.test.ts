// Programs that were read as UTF-8, typed in and saved before anything could be done: no letter is lost.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import * as iconv from '@vscode/iconv-lite-umd';

import { type Editor, Rescue, isUtf8, restore } from '../../src/rescue';

const TEXT = '%1 "Příliš žluťoučký kůň"\r\nN10 G54 "úpěl ďábelské"\r\nN20 M30 "ódy"\r\n';

/** A document of an editor that keeps the encoding in which it was read. */
class Document {
  encoding = 'utf8';
  text: string;
  isDirty = false;
  /** Typed as soon as the document is reverted. */
  afterRevert = '';

  constructor(public disk: Buffer) {
    this.text = iconv.decode(disk, 'utf8');
  }

  getText() {
    return this.text;
  }

  type(change: (text: string) => string) {
    this.text = change(this.text);
    this.isDirty = true;
  }

  save() {
    this.disk = Buffer.from(iconv.encode(this.text, this.encoding));
    this.isDirty = false;
  }
}

function editor(configured: string | undefined, answer?: string): Editor<Document> {
  return {
    read: async (document) => document.disk,
    write: async (document, bytes) => {
      document.disk = Buffer.from(bytes);
    },
    decode: async (bytes, encoding) => iconv.decode(Buffer.from(bytes), encoding),
    encode: async (text, encoding) => Buffer.from(iconv.encode(text, encoding)),
    configured: () => configured,
    ask: async () => answer,
    revert: async (document) => {
      document.text = iconv.decode(document.disk, document.encoding);
      document.isDirty = false;
      if (document.afterRevert !== '') {
        const typed = document.afterRevert;
        document.afterRevert = '';
        document.type((text) => text + typed);
      }
    },
    reopen: async (document, encoding) => {
      if (document.isDirty) {
        throw new Error('Cannot re-open a dirty text document with different encoding. Save it first.');
      }
      document.encoding = encoding;
      document.text = iconv.decode(document.disk, encoding);
    },
    replace: async (document, text) => document.type(() => text),
  };
}

const opened = (page: string, text = TEXT) => new Document(Buffer.from(iconv.encode(text, page)));
const replacement = Buffer.from('\uFFFD');

for (const page of ['cp852', 'windows1250', 'iso88592']) {
  test(`${page}: opened and typed in at once`, async () => {
    const document = opened(page);
    document.type((text) => text.replace('N20', 'N15 X5 "ř"\r\nN20').replace('G54', 'G55'));
    await new Rescue(editor(page)).restore(document);
    assert.equal(document.encoding, page);
    assert.equal(document.text, TEXT.replace('N20', 'N15 X5 "ř"\r\nN20').replace('G54', 'G55'));
    document.save();
    assert.equal(iconv.decode(document.disk, page), document.text);
  });

  test(`${page}: saved before it was read again`, async () => {
    const document = opened(page);
    document.type((text) => text.replace('M30', 'M30 "ž"').replace('%1', '%2'));
    const rescue = new Rescue(editor(page));
    const text = await rescue.beforeSave(document);
    assert.ok(text !== undefined);
    document.text = text;
    document.save();
    assert.ok(!document.disk.includes(replacement));
    await rescue.afterSave(document);
    assert.equal(iconv.decode(document.disk, page), TEXT.replace('M30', 'M30 "ž"').replace('%1', '%2'));
    assert.equal(document.encoding, page);
    assert.equal(document.text, TEXT.replace('M30', 'M30 "ž"').replace('%1', '%2'));
  });
}

test('nothing is asked and nothing typed: read again', async () => {
  const document = opened('windows1250');
  await new Rescue(editor('utf8', 'windows1250')).restore(document);
  assert.deepEqual([document.text, document.isDirty, document.encoding], [TEXT, false, 'windows1250']);
});

test('saved while the question is open: the bytes stay', async () => {
  const document = opened('windows1250');
  const before = document.disk;
  document.type((text) => `${text}N30\r\n`);
  const rescue = new Rescue(editor(undefined));
  document.text = (await rescue.beforeSave(document)) ?? '';
  document.save();
  await rescue.afterSave(document);
  assert.deepEqual(document.disk, Buffer.concat([before, Buffer.from('N30\r\n')]));
});

test('bytes that the configured code page does not have stay', async () => {
  const document = new Document(Buffer.from([...Buffer.from('%1 "'), 0x81, 0xf8, ...Buffer.from('"\r\nN10 M30\r\n')]));
  const before = document.disk;
  document.type((text) => text.replace('M30', 'M02'));
  const rescue = new Rescue(editor('windows1250'));
  document.text = (await rescue.beforeSave(document)) ?? '';
  document.save();
  await rescue.afterSave(document);
  assert.deepEqual(document.disk, Buffer.from(before.toString('latin1').replace('M30', 'M02'), 'latin1'));
});

test('typed on while it is read again: no letter is lost', async () => {
  const document = opened('cp852');
  document.type((text) => text.replace('G54', 'G55'));
  document.afterRevert = 'N30';
  await new Rescue(editor('cp852')).restore(document);
  assert.equal(document.text, TEXT.replace('G54', 'G55'));
});

test('a file that holds the replacement character itself is left alone', async () => {
  const document = new Document(Buffer.from('%1 "\uFFFD"\r\n'));
  document.type((text) => `${text}N10`);
  const rescue = new Rescue(editor('cp852'));
  await rescue.restore(document);
  assert.equal(await rescue.beforeSave(document), undefined);
  assert.equal(document.encoding, 'utf8');
});

test('what is typed where', () => {
  const restored = (page: string, change: (text: string) => string) => {
    const bytes = iconv.encode(TEXT, page);
    const typed = change(iconv.decode(bytes, 'utf8'));
    return restore(bytes, typed, iconv.decode(bytes, page));
  };
  const lines = (text: string) => text.split('\r\n');
  const moved = (text: string) => [lines(text)[1], lines(text)[0], ...lines(text).slice(2)].join('\r\n');
  const twice = (text: string) => [lines(text)[0], ...lines(text)].join('\r\n');
  for (const page of ['cp852', 'windows1250', 'iso88592']) {
    for (const change of [
      (text: string) => text,
      (text: string) => text.replace('%1 "', '%1 "x'),
      (text: string) => text.replace('"\r\nN10', 'x"\r\nN10'),
      (text: string) => text.replace('%1', ''),
      (text: string) => text.replace('N20 M30', 'N20 Y1\r\nN30 M30').replace('%1', '%7'),
      (text: string) => lines(text).slice(1).join('\r\n'),
      moved,
      twice,
    ]) {
      assert.equal(restored(page, change), change(TEXT), `${page} ${change}`);
    }
  }
});

test('what is UTF-8', () => {
  assert.ok(isUtf8(Buffer.from('kůň')) && isUtf8(Buffer.from('\uFFFD')) && !isUtf8(Buffer.from([0x22, 0xf8, 0x22])));
});

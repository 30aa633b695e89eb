// The page of `compare`: both paths, changes in colours, a list that leads to each (CMP-4).

import assert from 'node:assert/strict';
import { writeFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';

import { drawn, folder, launch, open, run } from './chromium.mjs';

const OLD = `%1 "flange"
N10 G17 G90 G40 G54
N20 T5 M06
N30 S1200 M03
N40 G00 X0 Y0 Z50
N50 M08
N60 Z5
N70 G01 Z-2 F200
N80 X60 F800
N90 Y40
N100 G02 X40 Y60 I-20 J0
N110 G01 X0
N120 Y0
N130 G00 Z50
N140 T6 M06
N150 G00 X20 Y20
N160 Z5
N170 G01 Z-8 F100
N180 G00 Z50
N190 M30
`;
const NEW = OLD.replace('Z-2 F200', 'Z-2.2 F200')
  .replace('F800', 'F650')
  .replace('N140', 'N135 G01 X80 F500\nN136 Y80\nN140')
  .replace('Z-8', 'Z-7.5');

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close(), { timeout: 10_000 });

/** The page of two programs, and the answer of `compare --format json`. */
function compared(old, now, name) {
  const [a, b, out] = ['old.nc', 'new.nc', `${name}.html`].map((file) => path.join(folder, file));
  writeFileSync(a, old);
  writeFileSync(b, now);
  const done = run('compare', a, b, '-o', out, '--format', 'json', '--lang', 'en');
  return { out, status: done.status, answer: JSON.parse(done.stdout) };
}

/** How many pixels of the picture have each of some colours, nearly. */
function pixels(tab, colours) {
  return tab.evaluate((colours) => {
    const canvas = document.getElementById('path');
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    return colours.map((colour) => {
      const parts = [1, 3, 5].map((at) => Number.parseInt(colour.slice(at, at + 2), 16));
      let count = 0;
      for (let at = 0; at < data.length; at += 4) {
        count += parts.every((part, i) => Math.abs(data[at + i] - part) < 12) ? 1 : 0;
      }
      return count;
    });
  }, colours);
}

const [NEW_PATH, OLD_PATH, CHOSEN] = ['#00805f', '#d55e00', '#e0218a'];

test('both paths, and a list that leads to the changes', async () => {
  const { out, status, answer } = compared(OLD, NEW, 'changes');
  assert.equal(status, 1);
  const { tab, wrong, close } = await open(browser, out);
  assert.deepEqual(await tab.evaluate(() => window.cnc872c.changes()), answer.changes);
  assert.equal(answer.changes.length, 4);
  assert.match(await tab.innerText('.tabs'), /Changes \(4\)/);
  assert.equal(await tab.inputValue('#colour'), 'change');
  // Both paths are in the picture, 0.2 mm apart.
  await tab.evaluate(() => window.cnc872c.view('XZ'));
  await drawn(tab);
  const [fresh, before] = await pixels(tab, [NEW_PATH, OLD_PATH]);
  assert.ok(fresh > 300 && before > 20, `${fresh} ${before}`);
  // The line that follows a deeper plunge is another one too: no change names it.
  const apart = await tab.evaluate(() => [window.cnc872c.project(8, 'new'), window.cnc872c.project(8, 'old')]);
  assert.ok(apart[0].y > apart[1].y && apart[0].x === apart[1].x, JSON.stringify(apart));
  // The old path can be hidden.
  await tab.getByLabel('Old path').uncheck();
  await drawn(tab);
  assert.equal((await pixels(tab, [OLD_PATH]))[0], 0);
  await tab.getByLabel('Old path').check();
  await tab.evaluate(() => window.cnc872c.view('iso'));
  // A click in the list takes the first block of the change, and colours all of it.
  for (const [place, change] of answer.changes.entries()) {
    await tab.click(`[data-change="${place}"]`);
    await drawn(tab);
    assert.equal(await tab.evaluate(() => window.cnc872c.current().seq), change.new_blocks[0][0]);
    assert.equal(await tab.getAttribute(`[data-change="${place}"]`, 'aria-current'), '');
    assert.ok((await pixels(tab, [CHOSEN]))[0] > 0, `change ${place}`);
  }
  // By script likewise; another block shows its own change, and one without a change none.
  assert.equal(await tab.evaluate(() => window.cnc872c.change(2)), true);
  assert.equal(await tab.evaluate(() => window.cnc872c.current().n), 135);
  assert.equal(await tab.evaluate(() => window.cnc872c.change(4)), false);
  await tab.evaluate(() => window.cnc872c.select(8));
  assert.equal(await tab.getAttribute('[data-change="1"]', 'aria-current'), '');
  await tab.evaluate(() => window.cnc872c.select(0));
  assert.equal(await tab.locator('[data-change][aria-current]').count(), 0);
  // In Czech.
  await tab.evaluate(() => window.cnc872c.language('cs'));
  assert.match(await tab.innerText('.changes'), /T5: Z −0.2, bloků: 1 \(N70\)/);
  assert.deepEqual(wrong, []);
  await close();
});

test('what the new program lacks is shown where it was', async () => {
  const { out, answer } = compared(NEW, OLD, 'removed');
  const place = answer.changes.findIndex(({ kind }) => kind === 'removed');
  const { tab, wrong, close } = await open(browser, out);
  await tab.evaluate(() => window.cnc872c.select(3));
  await tab.evaluate((place) => window.cnc872c.change(place), place);
  await drawn(tab);
  assert.equal(await tab.evaluate(() => window.cnc872c.current()), null);
  assert.ok((await pixels(tab, [CHOSEN]))[0] > 50);
  const at = await tab.evaluate((seq) => window.cnc872c.project(seq, 'old'), answer.changes[place].old_blocks[0][0]);
  assert.ok(at !== null);
  assert.deepEqual(wrong, []);
  await close();
});

test('equal programs, and a page of view', async () => {
  const same = compared(OLD, OLD.replace('G01 Z-2', 'G1 Z-2.'), 'same');
  assert.equal(same.status, 0);
  const first = await open(browser, same.out);
  assert.match(await first.tab.innerText('.changes'), /the programs do the same/);
  await drawn(first.tab);
  assert.deepEqual(await pixels(first.tab, [NEW_PATH, OLD_PATH]), [0, 0]);
  assert.deepEqual(first.wrong, []);
  await first.close();
  const out = path.join(folder, 'plain.html');
  run('view', path.join(folder, 'new.nc'), '-o', out);
  const { tab, close } = await open(browser, out);
  assert.deepEqual(await tab.evaluate(() => [window.cnc872c.changes(), window.cnc872c.change(0)]), [[], false]);
  await assert.rejects(
    tab.evaluate(() => window.cnc872c.colour('change')),
    /RangeError/,
  );
  assert.equal(await tab.locator('text=Old path').isVisible(), false);
  await close();
});

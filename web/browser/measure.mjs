// What the viewer takes in Chromium, without a graphics processor:
//
//   node browser/measure.mjs PROGRAM [WIDTH HEIGHT]
//
// Times are medians; memory is what scripts and their data hold after collection.

import { statSync } from 'node:fs';

import { launch, open, page } from './chromium.mjs';

const [program, width = 1280, height = 800] = process.argv.slice(2);
const FRAMES = 40;
const PICKS = 40;

const median = (times) => times.toSorted((a, b) => a - b)[Math.floor(times.length / 2)];
const row = (name, value) => console.log(`${name.padEnd(40)} ${value}`);

const file = page(program);
const browser = await launch();
const { tab, wrong, close } = await open(browser, file, { width: Number(width), height: Number(height) });
row('page', `${(statSync(file).size / 1e6).toFixed(2)} MB`);
row('opening to path', `${await tab.evaluate(() => Math.round(performance.now()))} ms at most`);
row('segments', await tab.evaluate(() => window.cnc872c.info().segments));

const session = await tab.context().newCDPSession(tab);
await session.send('HeapProfiler.collectGarbage');
const { usedSize, backingStorageSize = 0 } = await session.send('Runtime.getHeapUsage');
row('memory', `${((usedSize + backingStorageSize) / 1e6).toFixed(0)} MB`);

const picks = await tab.evaluate((count) => {
  const { clientWidth, clientHeight } = document.querySelector('#path');
  return Array.from({ length: count }, (_, i) => {
    const start = performance.now();
    window.cnc872c.pick((clientWidth * (i + 1)) / (count + 1), clientHeight / 2);
    return performance.now() - start;
  });
}, PICKS);
row('point to block', `${median(picks).toFixed(1)} ms`);

const marks = await tab.evaluate(async (count) => {
  const { blocks } = window.cnc872c.info();
  const times = [];
  for (let i = 0; i < count; i += 1) {
    const start = performance.now();
    window.cnc872c.select(Math.floor((blocks * (i + 1)) / (count + 2)));
    times.push(performance.now() - start);
    await new Promise((done) => requestAnimationFrame(done));
  }
  return times;
}, PICKS);
row('cursor to highlight', `${median(marks).toFixed(1)} ms and a frame`);

// Turning by hand: in every frame the pointer moves once.
const box = await tab.locator('#path').boundingBox();
const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
await tab.mouse.move(x, y);
await tab.mouse.down();
await tab.mouse.move(x + 5, y);
const frames = await tab.evaluate(
  async ({ count, x, y }) => {
    const canvas = document.querySelector('#path');
    const times = [];
    let last;
    for (let i = 0; i < count; i += 1) {
      const at = { bubbles: true, pointerId: 1, pointerType: 'mouse', buttons: 1, clientX: x + 3 * i, clientY: y + i };
      canvas.dispatchEvent(new PointerEvent('pointermove', at));
      const now = await new Promise((done) => requestAnimationFrame(done));
      if (last !== undefined) {
        times.push(now - last);
      }
      last = now;
    }
    return times;
  },
  { count: FRAMES, x, y },
);
await tab.mouse.up();
row('frame while turning', `${median(frames).toFixed(0)} ms`);
for (const what of wrong) {
  console.error(what);
}
await close();
await browser.close();

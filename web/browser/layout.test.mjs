// How a page opens and where its parts stand: findings first, lathes, what is fitted, hover, the divider, a phone, the chart.

import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { after, before, test } from 'node:test';

import { drawn, folder, launch, open, page, root, run } from './chromium.mjs';

const sample = (name) => path.join(root, 'samples', name);
let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close(), { timeout: 10_000 });

/** A program of its own. */
function program(name, ...lines) {
  const place = path.join(folder, 'layout');
  mkdirSync(place, { recursive: true });
  writeFileSync(path.join(place, name), `${lines.join('\n')}\n`);
  return path.join(place, name);
}

test('a program with errors opens on its findings, drawn up to the first', { timeout: 60_000 }, async () => {
  const file = program(
    'late.nc',
    '%1',
    'N10 G90 G0 X0 Y0 Z0',
    'N20 G1 X50 F100',
    'N30 Y30',
    'N40 X0 X5',
    'N50 Y0',
    'N60 M30',
  );
  const { tab, wrong, close } = await open(browser, page(file));
  const shown = await tab.evaluate(() => ({
    tab: document.querySelector('[role="tab"][aria-selected="true"]').textContent,
    panel: document.querySelector('#panel-findings').innerText,
    info: window.cnc872c.info(),
  }));
  assert.equal(shown.tab, 'Findings (1)');
  assert.match(shown.panel, /E0306 error late\.nc:5/);
  assert.deepEqual([shown.info.segments, shown.info.blocks, shown.info.left_out], [2, 6, 4]);
  assert.deepEqual(wrong, []);
  await close();
  const fine = await open(browser, page(sample('ok/flange.nc')));
  assert.equal(
    await fine.tab.evaluate(() => document.querySelector('[role="tab"][aria-selected="true"]').textContent),
    'Block',
  );
  await fine.close();
});

test('what is not known makes times and paths at least', { timeout: 60_000 }, async () => {
  const facts = () => document.querySelector('.facts').textContent;
  const faulty = program('stops.nc', '%1', 'N10 G90 G0 X0 Y0 Z0', 'N20 G1 X50 F100', 'N30 Y0 Y5', 'N40 M30');
  const stopped = await open(browser, page(faulty));
  assert.match(await stopped.tab.evaluate(facts), /4 · at least 30/);
  await stopped.close();
  const cycle = program(
    'holes.nc',
    '%1',
    'N10 G90 G0 X0 Y0 Z5',
    'N20 G2 I1 F100',
    'N30 G81 X10 Y10 Z-5',
    'N40 X20',
    'N50 G80 G0 Z50',
    'N60 M30',
  );
  const { tab, wrong, close } = await open(browser, page(cycle));
  assert.doesNotMatch(await tab.evaluate(facts), /approach/);
  assert.match(await tab.evaluate(() => document.querySelector('.notes').textContent), /not drawn.*: 4/);
  await tab.click('#tab-measure');
  const stretch = async (from, to) => {
    await tab.evaluate((seq) => window.cnc872c.select(seq), from);
    await tab.click('[data-focus="from"]');
    await tab.evaluate((seq) => window.cnc872c.select(seq), to);
    await tab.click('[data-focus="to"]');
    return tab.evaluate(() => [...document.querySelectorAll('.measure dd')].slice(1).map((part) => part.textContent));
  };
  assert.equal((await stretch(1, 1))[0], '6.283 mm');
  const [path, time] = await stretch(1, 3);
  assert.equal(path, 'at least 6.283 mm');
  assert.match(time, /^at least /);
  assert.deepEqual(wrong, []);
  await close();
});

test('a lathe is seen in ZX, with diameters along X', { timeout: 60_000 }, async () => {
  const { tab, wrong, close } = await open(browser, page(sample('ok/turned-shaft.nc')));
  const at = await tab.evaluate(() => {
    const api = window.cnc872c;
    const places = [];
    for (let seq = 0; seq < api.info().blocks; seq += 1) {
      api.select(seq);
      const { motion, position } = api.current();
      const place = api.project(seq);
      if (place !== null && motion.type === 'linear') {
        places.push({
          ...place,
          X: ((motion.start.X ?? position.X) + position.X) / 2,
          Z: ((motion.start.Z ?? position.Z) + position.Z) / 2,
        });
      }
    }
    api.view('ZX');
    const seq = 40;
    api.select(seq);
    return { places, state: document.querySelector('.state')?.textContent };
  });
  const [low, high] = [Math.min, Math.max].map((of) =>
    at.places.find(({ Z }) => Z === of(...at.places.map((place) => place.Z))),
  );
  assert.ok(high.x > low.x, 'Z to the right');
  const [near, far] = [Math.min, Math.max].map((of) =>
    at.places.find(({ X }) => X === of(...at.places.map((place) => place.X))),
  );
  assert.ok(far.y < near.y, 'X up');
  await drawn(tab);
  assert.match(await tab.evaluate(() => document.querySelector('.cells').textContent), /X14\.000Ø 28\.000/);
  // The size of the work is that of the set-up sheet, in diameters.
  await tab.click('#tab-measure');
  const sizes = await tab.evaluate(() =>
    [...document.querySelectorAll('.measure table')[0].querySelectorAll('tr')]
      .slice(1)
      .map((row) => [...row.children].map((cell) => cell.textContent)),
  );
  const { X } = JSON.parse(run('report', sample('ok/turned-shaft.nc'), '--format', 'json').stdout).extents.working;
  assert.deepEqual(sizes[0], ['ØX', X[0], X[1], X[1] - X[0]].map(String));
  assert.deepEqual(
    sizes.map(([name]) => name),
    ['ØX', 'Z'],
    'Y never moves',
  );
  assert.deepEqual(wrong, []);
  await close();
});

test('fit shows the working motions, and all when pressed again', { timeout: 60_000 }, async () => {
  const file = program(
    'far.nc',
    '%1',
    'N10 G17 G90 G0 X0 Y0 Z0',
    'N20 G1 X20 F100',
    'N30 Y20',
    'N40 G0 X900 Y900',
    'N50 M30',
  );
  const { tab, wrong, close } = await open(browser, page(file));
  const wide = () => tab.evaluate(() => window.cnc872c.project(2).x - window.cnc872c.project(1).x);
  const first = await wide();
  assert.ok(first > 50, 'the page opens on the work');
  await tab.evaluate(() => window.cnc872c.view('XY'));
  assert.ok((await wide()) < first / 5, 'a plane shows all');
  await tab.evaluate(() => window.cnc872c.view('fit'));
  assert.ok(Math.abs((await wide()) - first) < 1);
  await tab.evaluate(() => window.cnc872c.view('fit'));
  assert.ok((await wide()) < first / 5);
  assert.deepEqual(wrong, []);
  await close();
});

test('words beside the pointer', { timeout: 60_000 }, async () => {
  const { tab, wrong, close } = await open(browser, page(sample('ok/flange.nc')));
  const place = await tab.evaluate(() => {
    const { x, y } = window.cnc872c.project(60);
    const { left, top } = document.querySelector('#path').getBoundingClientRect();
    return { x: left + x, y: top + y };
  });
  await tab.mouse.move(place.x, place.y);
  await drawn(tab);
  const words = await tab.evaluate(() => document.querySelector('.hover').textContent);
  assert.match(words, /^N\d+ · (linear|arc)[a-z -]* · F \d+ mm\/min · [\d.]+ mm$/);
  await tab.mouse.move(2, 2);
  await drawn(tab);
  assert.ok(await tab.evaluate(() => document.querySelector('.hover').hidden));
  assert.deepEqual(wrong, []);
  await close();
});

test('the edge between path and text moves', { timeout: 60_000 }, async () => {
  const { tab, wrong, close } = await open(browser, page(sample('ok/flange.nc')));
  const widths = () =>
    tab.evaluate(() => ['#path', 'aside'].map((name) => document.querySelector(name).getBoundingClientRect().width));
  const [path0, text0] = await widths();
  const edge = await tab.evaluate(() => {
    const { x, y, width, height } = document.querySelector('.divider').getBoundingClientRect();
    return { x: x + width / 2, y: y + height / 2 };
  });
  await tab.mouse.move(edge.x, edge.y);
  await tab.mouse.down();
  await tab.mouse.move(edge.x - 150, edge.y, { steps: 4 });
  await tab.mouse.up();
  await drawn(tab);
  const [path1, text1] = await widths();
  assert.ok(Math.abs(text1 - text0 - 150) < 6 && path1 < path0 - 140, `${text0} ${text1}`);
  await tab.focus('.divider');
  await tab.keyboard.press('ArrowRight');
  assert.ok((await widths())[1] < text1);
  assert.deepEqual(wrong, []);
  await close();
});

test('on a narrow screen the player stays under the path', { timeout: 60_000 }, async () => {
  const { tab, wrong, close } = await open(browser, page(sample('ok/flange.nc')), { width: 390, height: 844 });
  const boxes = await tab.evaluate(() =>
    ['.stage', '.player', '.chart', '.text'].map((name) => {
      const { top, bottom, right } = document.querySelector(name).getBoundingClientRect();
      return { top, bottom, right };
    }),
  );
  const [stage, player, chart, text] = boxes;
  assert.ok(Math.abs(player.top - stage.bottom) < 2 && player.bottom <= 844, JSON.stringify(boxes));
  assert.ok(chart.top >= player.bottom - 1 && text.top >= chart.bottom - 1);
  assert.ok(boxes.every(({ right }) => right <= 391));
  assert.ok(await tab.evaluate(() => document.documentElement.scrollWidth <= 390));
  assert.deepEqual(wrong, []);
  await close();
});

test('the chart has the scale of working motions, with units', { timeout: 60_000 }, async () => {
  const file = program('slow.nc', '%1', 'N10 G17 G90 G0 X0 Y0 Z0', 'N20 G0 X300', 'N30 G1 X320 F100', 'N40 M30');
  for (const locale of ['en-GB', 'cs-CZ']) {
    const { tab, wrong, close } = await open(browser, page(file), { locale });
    await drawn(tab);
    const said = () => tab.evaluate(() => document.querySelector('.cut').textContent);
    assert.equal(await said(), locale === 'cs-CZ' ? 'rychloposuvy nahoře oříznuty' : 'rapids cut off at the top');
    await tab.click('.chart label');
    assert.equal(await said(), '');
    assert.deepEqual(wrong, []);
    await close();
  }
});

/** How many colours the path's canvas shows. */
async function colours(tab) {
  await drawn(tab);
  return tab.evaluate(async () => {
    await new Promise(requestAnimationFrame);
    const image = new Image();
    image.src = document.querySelector('#path').toDataURL();
    await image.decode();
    const context = Object.assign(document.createElement('canvas'), {
      width: image.width,
      height: image.height,
    }).getContext('2d');
    context.drawImage(image, 0, 0);
    return new Set(new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer)).size;
  });
}

test('where nothing can be drawn there is no grid, and the findings are shown', { timeout: 60_000 }, async () => {
  const file = program('none.nc', '%1', 'N10 G91 G00 X5 X6', 'N20 M30');
  const { tab, wrong, close } = await open(browser, page(file));
  const shown = await tab.evaluate(() => [
    document.querySelector('[role="tab"][aria-selected="true"]').textContent,
    window.cnc872c.info().drawn,
  ]);
  assert.deepEqual([...shown, await colours(tab)], ['Findings (1)', 0, 1]);
  assert.deepEqual(wrong, []);
  await close();
  const fine = await open(browser, page(sample('ok/flange.nc')));
  assert.ok((await colours(fine.tab)) > 2);
  await fine.close();
});

test('a long comment is read whole, and depth has its legend', { timeout: 60_000 }, async () => {
  const words = Array.from({ length: 60 }, (_, i) => `word${i}`).join(' ');
  const file = program('long.nc', '%1', 'N10 G17 G90 G0 X0 Y0 Z5', `N20 G1 X20 Z-3 F100 "${words}"`, 'N30 M30');
  const { tab, wrong, close } = await open(browser, page(file));
  await tab.evaluate(() => {
    window.cnc872c.select(1);
    window.cnc872c.colour('depth');
  });
  await drawn(tab);
  const seen = await tab.evaluate(() => {
    const comment = document.querySelector('.comments');
    const { overflowY, whiteSpace } = getComputedStyle(comment);
    return {
      text: comment.textContent,
      fits: comment.scrollWidth <= comment.clientWidth + 1,
      overflowY,
      whiteSpace,
      legend: document.querySelector('.legend').innerText,
    };
  });
  assert.ok(seen.text.includes('word59') && seen.fits, JSON.stringify(seen));
  assert.deepEqual([seen.overflowY, seen.whiteSpace], ['auto', 'normal']);
  assert.match(seen.legend, /-3(\.0+)?/);
  assert.deepEqual(wrong, []);
  await close();
});

test('what holds at a block: who wrote it, what comes next, how to start there', { timeout: 60_000 }, async () => {
  const file = program(
    'state.nc',
    '%1',
    'N10 G17 G90 G0 X0 Y0 Z0 R5=12.5 &0101',
    'N20 G1 X20 F100',
    'N30 Y20 R6=3',
    'N40 T1 M6',
    'N50 G0 X0',
    'N60 M30',
  );
  const { tab, wrong, close } = await open(browser, page(file, '--block-skip', '--param', 'R7=1'));
  await tab.evaluate(() => window.cnc872c.select(2));
  await drawn(tab);
  const state = await tab.evaluate(() => document.querySelector('.state').innerText);
  assert.match(state, /Parameters\s+R5\s+12\.5 N10\s+R6\s+3 N30\s+R7\s+1\s/);
  assert.match(state, /&\s+0101 N10/);
  assert.match(state, /next tool change\s+N40/);
  assert.match(state, /next rapid\s+N50/);
  assert.match(state, /blocks\s+3\s+3\s+path/);
  assert.match(state, /this tool\s+blocks\s+3\s+0/);
  assert.match(state, /F\s+100 mm\/min N20\s+S\s+not programmed yet/);
  const writer = await tab.evaluate(
    () => [...document.querySelectorAll('.state .chip')].find((chip) => chip.textContent === 'G01').title,
  );
  assert.equal(writer, 'written by N20 (seq 1, state.nc:3)');
  // A key on what a block wrote leads there, and stays at what it wrote.
  await tab.focus('.state [data-focus=feed]');
  await tab.keyboard.press('Enter');
  await drawn(tab);
  const at = await tab.evaluate(() => [window.cnc872c.current().seq, document.activeElement.dataset.focus]);
  assert.deepEqual(at, [1, 'feed']);
  await tab.evaluate(() => window.cnc872c.select(2));
  await drawn(tab);
  await tab.click('.restart button');
  const command = 'cnc872c restart state.nc --seq 2 --param R7=1 --block-skip';
  assert.equal(await tab.evaluate(() => document.querySelector('.command code').textContent), command);
  // Copied where there is a clipboard, else selected.
  const copy = async (clipboard) => {
    await tab.evaluate((clipboard) => {
      const value = clipboard ? { writeText: async (text) => Object.assign(window, { copied: text }) } : undefined;
      Object.defineProperty(navigator, 'clipboard', { value, configurable: true });
      document.querySelector('.command [role=status]').textContent = '';
    }, clipboard);
    await tab.click('.command button');
    await tab.waitForFunction(() => document.querySelector('.command [role=status]').textContent !== '');
    return tab.evaluate(() => document.querySelector('.command [role=status]').textContent);
  };
  assert.equal(await copy(true), 'copied');
  assert.equal(await tab.evaluate(() => window.copied), command);
  assert.equal(await copy(false), 'selected: copy it with Ctrl+C');
  assert.equal(await tab.evaluate(() => getSelection().toString()), command);
  await tab.evaluate(() => window.cnc872c.colour('depth'));
  assert.deepEqual(wrong, []);
  await close();
});

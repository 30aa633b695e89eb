// Pages in Chromium: what they show is what the streams say, without network, by keyboard, for everybody.

import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { after, before, test } from 'node:test';

import { drawn, folder, launch, open, page, records, root, run } from './chromium.mjs';

const sample = (name) => path.join(root, 'samples', name);
const PROGRAMS = [
  'ok/flange.nc',
  'ok/nested-loops.nc',
  'ok/groove-helix.nc',
  'ok/turned-shaft.nc',
  'ok/cam-surface.nc',
  'projects/five-axis/blade.nc',
  'projects/drilling/bolt-circle.nc',
  'rules/equ-corrections/program.nc',
];
/** Machines that move in other ways, as project files say, with a program that has joints of every kind. */
const MACHINES = {
  parabolic: '[motion]\nprofile = "parabolic"\n[motion.sets.1]\nparabolic = 20000\n',
  ramps: '[motion]\nprofile = "ramps"\n',
};
const JOINTS = `%1
N10 G23 G17 G90 G0 X0 Y0 Z0
N20 G1 X10 F1000
N30 X20 Y.2
N40 X30
N50 G2 X40 Y-10 I0 J-10
N60 G1 Y-30
N70 X10 Y-40
N80 X10.05
N90 G0 X0
N100 G1 Y0 F2500
N110 G4 Q50
N120 X5
N130 X10 Z-1
N140 X15 Z-1.9
N150 X20 Z-3
N160 G24 X25
N170 X30
N180 M30
`;

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close(), { timeout: 10_000 });

/** Some of many: the first, the last, and between. */
function some(list, count) {
  return list.length <= count
    ? list
    : Array.from({ length: count }, (_, i) => list[Math.round((i * (list.length - 1)) / (count - 1))]);
}

const FEEDS = ['programmed', 'cap', 'start', 'peak', 'end'];
const near = (a, b, what, absolute, relative) =>
  assert.ok(Math.abs(a - b) <= Math.max(absolute, relative * Math.abs(b)), `${what}: ${a}, not ${b}`);

/** The fields of the motion record, within what the contract allows. */
function sameMotion(shown, motion) {
  const { kind: _, seq, n, file, line, joint, ...fields } = motion;
  assert.deepEqual([shown.seq, shown.n, shown.file, shown.line], [seq, n, file, line]);
  for (const [name, value] of Object.entries(fields)) {
    if (FEEDS.includes(name)) {
      near(shown[name], value, `${seq} ${name}`, 0.001, 1e-6);
    } else if (name.endsWith('_s')) {
      near(shown[name], value, `${seq} ${name}`, 0.001, 0);
    } else if (typeof value === 'number') {
      near(shown[name], value, `${seq} ${name}`, 1e-6, 1e-6);
    } else {
      assert.deepEqual(shown[name], value, `${seq} ${name}`);
    }
  }
  assert.equal(shown.joint === undefined, joint === undefined, `${seq} joint`);
  for (const [name, value] of Object.entries(joint ?? {})) {
    if (name === 'angle_deg') {
      near(shown.joint[name], value, `${seq} angle`, 0.01, 0);
    } else if (name === 'feed') {
      near(shown.joint[name], value, `${seq} joint`, 0.001, 1e-6);
    } else {
      assert.deepEqual(shown.joint[name], value, `${seq} joint.${name}`);
    }
  }
}

function sameAsStreams(name, file) {
  test(`the state of ${name} is that of the streams`, { timeout: 180_000 }, async () => {
    const blocks = records('compile', file).filter((record) => record.kind === 'block');
    const motions = records('motion', file).filter((record) => record.kind === 'block');
    const { tab, wrong, close } = await open(browser, page(file));
    const info = await tab.evaluate(() => window.cnc872c.info());
    assert.equal(info.blocks, blocks.length);
    assert.equal(info.from, 0);
    assert.equal(info.drawn, info.segments);
    for (const block of some(blocks, 40)) {
      const shown = await tab.evaluate(
        (seq) => (window.cnc872c.select(seq) ? window.cnc872c.current() : null),
        block.seq,
      );
      const { start_s, motion: moved, ...rest } = block;
      assert.equal(start_s, undefined);
      for (const [field, value] of Object.entries({ ...rest, ...(moved && { motion: moved }) })) {
        assert.deepEqual(shown[field], value, `${block.seq} ${field}`);
      }
      sameMotion(shown, motions[block.seq]);
      const passes = blocks.filter(
        (other) => other.file === block.file && other.line === block.line && other !== block,
      );
      assert.deepEqual(
        shown.passes,
        passes.map((other) => other.seq),
      );
    }
    const dots = await tab.evaluate(() => window.cnc872c.dots());
    const expected = motions.filter((record) => record.joint?.dot !== undefined);
    assert.deepEqual(
      dots.map(({ seq, n, dot, reason }) => ({ seq, n, dot, reason })),
      expected.map((record) => ({
        seq: record.seq,
        n: record.n,
        dot: record.joint.dot,
        reason: record.joint.broken_by ?? record.joint.limited_by,
      })),
    );
    const red = expected.filter((record) => record.joint.dot === 'red');
    const listed = await tab.evaluate(() =>
      [...document.querySelectorAll('.joints [data-seq]')].map((element) => Number(element.dataset.seq)),
    );
    assert.deepEqual(
      listed,
      red.slice(0, listed.length).map((record) => record.seq),
    );
    assert.ok(listed.length >= Math.min(red.length, 300));
    assert.deepEqual(wrong, []);
    await close();
  });
}

for (const name of PROGRAMS) {
  sameAsStreams(name, sample(name));
}
for (const [name, machine] of Object.entries(MACHINES)) {
  const place = path.join(folder, name);
  mkdirSync(place);
  writeFileSync(path.join(place, 'cnc872c.toml'), machine);
  writeFileSync(path.join(place, 'joints.nc'), JOINTS);
  sameAsStreams(`joints, ${name}`, path.join(place, 'joints.nc'));
}

test('a line is picked where it is drawn', { timeout: 180_000 }, async () => {
  const file = sample('ok/flange.nc');
  const { tab, wrong, close } = await open(browser, page(file));
  const found = await tab.evaluate(() => {
    const api = window.cnc872c;
    const seen = [];
    for (const plane of ['iso', 'XY', 'XZ', 'YZ', 'fit']) {
      api.view(plane);
      for (let seq = 0; seq < api.info().blocks; seq += 1) {
        const place = api.project(seq);
        if (place === null) {
          continue;
        }
        const picked = api.pick(place.x, place.y);
        api.select(seq);
        seen.push({ plane, seq, picked, again: api.pick(place.x, place.y) });
      }
    }
    return seen;
  });
  assert.ok(found.length > 400);
  for (const { plane, seq, picked, again } of found) {
    assert.notEqual(picked, null, `${plane} ${seq}`);
    assert.equal(again, seq, `${plane}: the block in hand comes first`);
  }
  const nothing = await tab.evaluate(() => [
    window.cnc872c.pick(2, 2),
    window.cnc872c.project(0),
    window.cnc872c.select(99999),
  ]);
  assert.deepEqual(nothing, [null, null, false]);
  assert.deepEqual(wrong, []);
  await close();
});

test('scripts and messages', { timeout: 180_000 }, async () => {
  const file = page(sample('ok/nested-loops.nc'));
  const { tab, wrong, close } = await open(browser, file);
  const told = await tab.evaluate(async () => {
    const api = window.cnc872c;
    const events = [];
    window.addEventListener('cnc872c:select', (event) => events.push(event.detail));
    const throws = (run) => {
      try {
        run();
        return false;
      } catch {
        return true;
      }
    };
    api.select(5);
    api.select(5);
    api.select(7);
    for (const by of ['motion', 'feed', 'velocity', 'tool', 'set', 'time']) {
      api.colour(by);
    }
    const wrongNames = [() => api.colour('x'), () => api.view('YX'), () => api.language('de')].map(throws);
    api.language('cs');
    const heading = document.querySelector('.chart h2').textContent;
    const lang = document.documentElement.lang;
    api.language('en');
    api.play(100);
    await new Promise((resolve) => setTimeout(resolve, 400));
    api.stop();
    return { events: events.slice(0, 2), played: events.length > 2, wrongNames, heading, lang, before: api.select(-1) };
  });
  assert.deepEqual(
    told.events.map((event) => event.seq),
    [5, 7],
  );
  assert.deepEqual(Object.keys(told.events[0]), ['seq', 'file', 'line']);
  assert.deepEqual(told.wrongNames, [true, true, true]);
  assert.deepEqual([told.heading, told.lang, told.before], ['Rychlost', 'cs', false]);
  assert.ok(told.played, 'playing goes on from block to block');
  assert.deepEqual(wrong, []);
  await close();

  // An embedding page asks by messages, and hears of each selection.
  const outer = path.join(folder, 'outer.html');
  writeFileSync(
    outer,
    `<!doctype html><script>window.cnc872c = { ready: Promise.resolve() };</script><iframe src="${path.basename(file)}" width="900" height="700"></iframe>`,
  );
  const embedding = await open(browser, outer);
  const answers = await embedding.tab.evaluate(async () => {
    const frame = document.querySelector('iframe');
    const heard = [];
    window.addEventListener('message', (event) => heard.push(event.data));
    const ask = (name, ...args) => frame.contentWindow.postMessage({ cnc872c: name, args, id: heard.length + 1 }, '*');
    const until = async (test) => {
      for (let tries = 0; tries < 100 && !heard.some(test); tries += 1) {
        await new Promise((resolve) => setTimeout(resolve, 50));
      }
    };
    for (let tries = 0; tries < 60 && heard.length === 0; tries += 1) {
      ask('info');
      await new Promise((resolve) => setTimeout(resolve, 50));
    }
    ask('select', 3);
    await until((message) => message.cnc872c === 'select' && message.detail);
    ask('nothing');
    await until((message) => message.error);
    return heard;
  });
  assert.ok(answers.some((message) => message.cnc872c === 'info' && message.result.blocks > 10));
  assert.ok(answers.some((message) => message.cnc872c === 'select' && message.detail?.seq === 3));
  assert.ok(
    answers.some((message) => message.cnc872c === 'select' && message.result === true && message.id !== undefined),
  );
  assert.ok(answers.some((message) => message.cnc872c === 'nothing' && typeof message.error === 'string'));
  assert.deepEqual(embedding.wrong, []);
  await embedding.close();
});

test('text and path are one', { timeout: 180_000 }, async () => {
  const file = sample('ok/flange.nc');
  const blocks = records('compile', file).filter((record) => record.kind === 'block');
  const { tab, close } = await open(browser, page(file));
  const block = blocks.find((record) => record.calls?.[0]?.of === 3);
  await tab.click(`.code [data-file="0"][data-line="${block.line}"]`);
  const first = await tab.evaluate(() => window.cnc872c.current());
  assert.equal(first.line, block.line);
  assert.equal(first.calls[0].pass, 1);
  await tab.click(`.code [data-file="0"][data-line="${block.line}"]`);
  const second = await tab.evaluate(() => window.cnc872c.current());
  assert.deepEqual([second.line, second.calls[0].pass], [block.line, 2]);
  await tab.evaluate((seq) => window.cnc872c.select(seq), blocks.at(-1).seq);
  const marked = await tab.evaluate(() => document.querySelector('.code .current').dataset.line);
  assert.equal(Number(marked), blocks.at(-1).line);
  await close();
});

test('keys alone reach everything', { timeout: 180_000 }, async () => {
  const { tab, close } = await open(browser, page(sample('ok/nested-loops.nc')));
  await tab.focus('#path');
  const seq = async (key) => {
    await tab.keyboard.press(key);
    return tab.evaluate(() => window.cnc872c.current()?.seq ?? null);
  };
  assert.equal(await seq('.'), 0);
  assert.equal(await seq('.'), 1);
  assert.equal(await seq(','), 0);
  const loop = await tab.evaluate(() => {
    const api = window.cnc872c;
    for (let seq = 0; seq < api.info().blocks; seq += 1) {
      api.select(seq);
      if (api.current().passes.length > 2 && api.current().passes[0] > seq) {
        return { seq, next: api.current().passes[0] };
      }
    }
    return null;
  });
  assert.equal(await seq(']'), loop.next);
  assert.equal(await seq('['), loop.seq);
  const place = () => tab.evaluate(() => JSON.stringify([1, 5, 9].map((n) => window.cnc872c.project(n))));
  let before = await place();
  for (const key of ['ArrowLeft', 'ArrowUp', 'Shift+ArrowRight', '+', '-', 'Home']) {
    await tab.keyboard.press(key);
    const now = await place();
    if (key !== '-') {
      assert.notEqual(now, before, key);
    }
    before = now;
  }
  await tab.keyboard.press('?');
  assert.ok(await tab.evaluate(() => document.querySelector('dialog').open));
  await tab.keyboard.press('Escape');
  // Tab reaches every control that can be seen, and shows where it is.
  const wanted = await tab.evaluate(() => {
    const controls = [...document.querySelectorAll('button, select, input, [tabindex="0"]')];
    const seen = controls.filter(
      (element) => !element.disabled && element.tabIndex >= 0 && element.checkVisibility({ visibilityProperty: true }),
    );
    seen.forEach((element, i) => {
      element.dataset.reach = String(i);
    });
    document.body.focus();
    document.activeElement.blur();
    return seen.length;
  });
  const reached = new Set();
  for (let press = 0; press < wanted + 10; press += 1) {
    await tab.keyboard.press('Tab');
    const at = await tab.evaluate(() => {
      const element = document.activeElement;
      return { at: element.dataset.reach, outline: getComputedStyle(element).outlineStyle };
    });
    if (at.at !== undefined) {
      reached.add(at.at);
      assert.notEqual(at.outline, 'none', 'the focus is seen');
    }
  }
  assert.equal(reached.size, wanted);
  await close();
});

test('nobody is shut out', { timeout: 180_000 }, async () => {
  const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
  const file = page(sample('ok/flange.nc'));
  for (const scheme of ['light', 'dark']) {
    const { tab, wrong, close } = await open(browser, file, { scheme, locale: scheme === 'dark' ? 'cs-CZ' : 'en-GB' });
    assert.equal(await tab.evaluate(() => document.documentElement.lang), scheme === 'dark' ? 'cs' : 'en');
    await tab.evaluate(() => window.cnc872c.select(20));
    await tab.addScriptTag({ content: axe });
    for (const panel of ['block', 'joints', 'findings', 'measure', 'filter']) {
      await tab.click(`#tab-${panel}`);
      const { violations } = await tab.evaluate(() => window.axe.run());
      const told = violations.map(
        ({ id, nodes }) => `${id}: ${nodes.map((node) => `${node.html} ${node.failureSummary}`).join('\n')}`,
      );
      assert.deepEqual(told, [], `${scheme} ${panel}`);
    }
    assert.deepEqual(wrong, []);
    await close();
  }
});

test('a program with errors, and a part of one', { timeout: 180_000 }, async () => {
  const bad = path.join(folder, 'bad.nc');
  writeFileSync(bad, '%1\nN10 G0 G90 X0 Y0 Z5\nN20 G1 X5 F100\nN30 G71 LR5\nN40 M30\n');
  let { tab, wrong, close } = await open(browser, page(bad));
  const shown = await tab.evaluate(() => ({
    info: window.cnc872c.info(),
    text: document.querySelector('.findings').textContent,
    notes: document.querySelector('.notes').textContent,
  }));
  assert.equal(shown.info.segments, 1);
  assert.match(shown.text, /W0503/);
  assert.match(shown.notes, /errors/);
  assert.deepEqual(wrong, []);
  await close();
  ({ tab, wrong, close } = await open(browser, page(sample('ok/flange.nc'), '--from', '30', '--blocks', '60')));
  const part = await tab.evaluate(() => ({
    info: window.cnc872c.info(),
    before: window.cnc872c.select(29),
    first: window.cnc872c.select(30),
    current: window.cnc872c.current(),
  }));
  const blocks = records('compile', sample('ok/flange.nc')).filter((record) => record.kind === 'block');
  assert.deepEqual([part.info.from, part.info.blocks, part.before, part.first], [30, blocks.length, false, true]);
  assert.equal(part.info.left_out >= blocks.length - 30, true);
  assert.deepEqual(part.current.position, blocks[30].position);
  assert.deepEqual(wrong, []);
  await close();
});

/** A page of a program that a test writes. */
function written(name, blocks, project = '', ...options) {
  const place = path.join(folder, name);
  mkdirSync(place, { recursive: true });
  writeFileSync(path.join(place, 'cnc872c.toml'), project);
  writeFileSync(path.join(place, 'part.nc'), `${blocks.join('\n')}\n`);
  return page(path.join(place, 'part.nc'), ...options);
}

const LOOP = [
  '%5 "LOOP"',
  'N10 G17 G23 G90 G0 X0 Y0 Z0 S1000 M3',
  'N20 G71 L1 Q3',
  'N30 G1 X90 Y50 F500',
  'N40 M9',
  'N50 M5',
  'N60 M0',
  'N70 M30',
  'N100 G79 L1',
  'N110 G91 G1 X20 F1000',
  'N120 Y10',
  'N130 G90 G70',
];

test('a click in the text shows all executions, one in the list goes there', { timeout: 180_000 }, async () => {
  const { tab, wrong, close } = await open(browser, written('loop', LOOP));
  await tab.evaluate(() => window.cnc872c.view('XY'));
  await tab.click('.code [data-line="10"]');
  await drawn(tab);
  // Those that are not in hand are seen too: fainter, on the canvas above the path.
  const marked = await tab.evaluate(() => {
    const { passes } = window.cnc872c.current();
    const canvas = document.querySelector('.marks');
    const context = canvas.getContext('2d');
    const pixel = (place) => [...context.getImageData(Math.round(place.x), Math.round(place.y), 1, 1).data];
    const others = passes.map((seq) => pixel(window.cnc872c.project(seq)));
    return { others, passes };
  });
  assert.equal(marked.passes.length, 2);
  for (const [red, green, blue, alpha] of marked.others) {
    assert.ok(alpha > 60 && red > green + 60 && red > blue, `${red} ${green} ${blue} ${alpha}`);
  }
  // Zoomed in, the place of a red dot is brought into the window.
  await tab.focus('#path');
  for (let press = 0; press < 14; press += 1) {
    await tab.keyboard.press('+');
  }
  await tab.click('#tab-joints');
  const last = tab.locator('.joints [data-seq]').last();
  const wanted = Number(await last.getAttribute('data-seq'));
  await last.click();
  assert.equal(await tab.evaluate(() => window.cnc872c.current().seq), wanted);
  await drawn(tab);
  const held = await tab.evaluate(() => !document.querySelector('.held').hidden);
  assert.ok(held, 'the block in hand is in the window');
  assert.deepEqual(wrong, []);
  await close();
});

test('the keyboard stays where it was when a panel changes', { timeout: 180_000 }, async () => {
  const { tab, close } = await open(browser, written('loop', LOOP));
  await tab.click('.code [data-line="10"]');
  const at = () => tab.evaluate(() => `${document.activeElement.tagName} ${document.activeElement.textContent}`);
  const press = async (selector, times = 1) => {
    await tab.focus(selector);
    const before = await at();
    for (let time = 0; time < times; time += 1) {
      await tab.keyboard.press('Enter');
      await drawn(tab);
      assert.equal(await at(), before);
    }
  };
  await press('[data-focus="next"]', 4);
  assert.equal(await tab.evaluate(() => window.cnc872c.current().calls[0].pass), 3, 'at the last pass it stays');
  await tab.click('#tab-measure');
  await press('[data-focus="pick"]');
  await press('[data-focus="clear"]');
  await press('[data-focus="from"]');
  await press('[data-focus="to"]');
  await tab.click('#tab-filter');
  await press('[data-focus="reset"]');
  await close();
});

test('playing goes on from a block that takes no time', { timeout: 180_000 }, async () => {
  const { tab, close } = await open(browser, written('loop', LOOP));
  const seen = await tab.evaluate(async () => {
    const api = window.cnc872c;
    const last = api.info().blocks - 1;
    const heard = [];
    api.select(last - 2);
    window.addEventListener('cnc872c:select', (event) => heard.push(event.detail.seq));
    api.play(1);
    await new Promise((resolve) => setTimeout(resolve, 400));
    return { heard, last, at: api.current().seq };
  });
  assert.equal(seen.at, seen.last);
  assert.ok(
    seen.heard.every((seq) => seq >= seen.last - 2),
    seen.heard.join(' '),
  );
  await close();
});

test('what is not drawn is said', { timeout: 180_000 }, async () => {
  const said = async (file) => {
    const { tab, wrong, close } = await open(browser, file);
    const found = await tab.evaluate(() => ({
      title: document.querySelector('h1').textContent,
      notes: document.querySelector('.notes').textContent,
    }));
    assert.deepEqual(wrong, []);
    await close();
    return found;
  };
  const axes = [...'XYZU'].map((letter) => `[[axes]]\nletter="${letter}"\nkind="linear"\n`).join('');
  const other = await said(
    written('u', ['%6 "U"', 'N10 G17 G90 G0 X0 Y0 Z0 U0', 'N20 G1 U50 F100', 'N30 X10', 'N40 M30'], axes),
  );
  assert.match(other.notes, /axes U is not drawn/);
  const broken = await said(written('broken', ['%5 "LOOP"', 'N5 G0 X0 X1', ...LOOP.slice(1)]));
  assert.equal(broken.title, '%5 LOOP');
  assert.match(broken.notes, /nothing of it is drawn/);
});

/** A picture as a grid of mean colours: what it looks like from far. */
async function coarse(tab) {
  return tab.evaluate(() => {
    const canvas = document.getElementById('path');
    const small = document.createElement('canvas');
    [small.width, small.height] = [48, 32];
    const context = small.getContext('2d');
    context.drawImage(canvas, 0, 0, 48, 32);
    return [...context.getImageData(0, 0, 48, 32).data].filter((_, i) => i % 4 !== 3);
  });
}

function difference(a, b) {
  assert.equal(a.length, b.length);
  return a.reduce((sum, value, i) => sum + Math.abs(value - b[i]), 0) / a.length;
}

test('pictures look as before', { timeout: 180_000 }, async () => {
  const stored = path.join(root, 'web/browser/pictures.json');
  const known = process.env.PICTURES === 'write' ? {} : JSON.parse(readFileSync(stored, 'utf8'));
  const made = {};
  for (const name of ['ok/flange.nc', 'ok/cam-surface.nc', 'ok/turned-shaft.nc']) {
    for (const [scheme, plane, by] of [
      ['light', 'iso', 'motion'],
      ['dark', 'XY', 'velocity'],
    ]) {
      const { tab, close } = await open(browser, page(sample(name)), { scheme, width: 1000, height: 700 });
      await tab.evaluate(
        ([plane, by]) => {
          window.cnc872c.view(plane);
          window.cnc872c.colour(by);
        },
        [plane, by],
      );
      await drawn(tab);
      const key = `${name} ${scheme} ${plane} ${by}`;
      made[key] = await coarse(tab);
      // A busy machine may draw later.
      for (let wait = 0; wait < 50 && known[key] !== undefined && difference(made[key], known[key]) >= 1.5; wait += 1) {
        await new Promise((resolve) => setTimeout(resolve, 100));
        made[key] = await coarse(tab);
      }
      if (known[key] !== undefined) {
        assert.ok(difference(made[key], known[key]) < 1.5, key);
      } else {
        assert.equal(process.env.PICTURES, 'write', `no picture is stored of ${key}`);
      }
      await close();
    }
  }
  if (process.env.PICTURES === 'write') {
    writeFileSync(stored, `${JSON.stringify(made)}\n`);
  }
});

test('both ways of drawing look alike', { timeout: 180_000 }, async () => {
  const file = page(sample('ok/flange.nc'));
  const pictures = [];
  for (const hash of ['#draw=software', '#draw=gl']) {
    const { tab, close } = await open(browser, file, { hash });
    assert.equal(await tab.evaluate(() => document.querySelector('.stage').dataset.renderer), hash.slice(6));
    await tab.evaluate(() => window.cnc872c.view('XY'));
    await drawn(tab);
    pictures.push(await coarse(tab));
    await close();
  }
  assert.ok(difference(...pictures) < 3);
});

test('still pictures open, with every dot', { timeout: 180_000 }, async () => {
  const file = sample('ok/cam-surface.nc');
  const svg = path.join(folder, 'cam.svg');
  assert.equal(run('view', file, '-o', svg).status, 0);
  const motions = records('motion', file).filter((record) => record.joint?.dot !== undefined);
  const context = await browser.newContext();
  const tab = await context.newPage();
  await tab.goto(`file://${svg}`);
  const seen = await tab.evaluate(() => ({
    red: [...document.querySelectorAll('.dot.red')].map((dot) => Number(dot.dataset.seq)),
    yellow: document.querySelectorAll('.dot.yellow').length,
    numbers: [...document.querySelectorAll('text')].filter((text) => /^N\d+/.test(text.textContent)).length,
  }));
  assert.deepEqual(
    seen.red,
    motions.filter((record) => record.joint.dot === 'red').map((record) => record.seq),
  );
  assert.equal(seen.yellow, motions.filter((record) => record.joint.dot === 'yellow').length);
  assert.equal(seen.numbers > 0, seen.red.length > 0);
  await context.close();
});

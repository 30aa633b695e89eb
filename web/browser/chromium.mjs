// Chromium without a network, and pages made by the built program.

import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

import { chromium } from 'playwright-core';

export const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
export const program = process.env.CNC872C ?? path.join(root, 'target/debug/cnc872c');

const ARGUMENTS = [
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];

/** A folder that is gone at the end. */
export const folder = mkdtempSync(path.join(tmpdir(), 'cnc872c-view-'));
process.on('exit', () => rmSync(folder, { recursive: true, force: true }));

/** Runs the built program. */
export function run(...args) {
  const done = spawnSync(program, args, { encoding: 'utf8', maxBuffer: 1 << 30 });
  if (done.error !== undefined) {
    throw done.error;
  }
  return done;
}

/** A page of a program; the file. */
export function page(file, ...options) {
  const name = `${path.basename(file, path.extname(file))}-${Math.random().toString(36).slice(2, 8)}.html`;
  const out = path.join(folder, name);
  const done = run('view', file, '-o', out, ...options);
  if (done.status === 2) {
    throw new Error(done.stderr);
  }
  return out;
}

/** The records of a stream, by command: `compile`, `motion`. */
export function records(command, file, ...options) {
  const format = command === 'motion' ? ['--format', 'json'] : [];
  return run(command, file, ...format, ...options)
    .stdout.trimEnd()
    .split('\n')
    .map((line) => JSON.parse(line));
}

export function launch() {
  const executablePath = process.env.CHROMIUM ?? '/usr/bin/chromium';
  return chromium.launch({ executablePath, args: ARGUMENTS });
}

/** A tab in which anything but files is refused, and whatever goes wrong is kept. */
export async function open(
  browser,
  file,
  { width = 1280, height = 800, scheme = 'light', hash = '', locale = 'en-GB' } = {},
) {
  const context = await browser.newContext({ viewport: { width, height }, colorScheme: scheme, locale });
  const wrong = [];
  await context.route('**', (route) => {
    const url = route.request().url();
    if (/^(file|data|blob):/.test(url)) {
      return route.continue();
    }
    wrong.push(`asks for ${url}`);
    return route.abort();
  });
  const tab = await context.newPage();
  tab.on('console', (message) => {
    if (message.type() === 'error') {
      wrong.push(message.text());
    }
  });
  tab.on('pageerror', (error) => wrong.push(String(error.stack ?? error)));
  await tab.goto(`file://${file}${hash}`);
  await tab.evaluate(() => window.cnc872c.ready);
  return { tab, wrong, close: () => context.close() };
}

/** Once all that was asked for is drawn: a change asks for a frame, whose callback may ask for the next. */
export function drawn(tab) {
  return tab.evaluate(async () => {
    for (let frame = 0; frame < 3; frame += 1) {
      await new Promise(requestAnimationFrame);
    }
  });
}

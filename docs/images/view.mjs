// Makes the pictures of the README and of docs/guide/view: two still pictures, and the page in light and dark. Needs Node 20,
// `npm ci` in web/, Chromium (see web/browser/run), and the built program: CNC872C, else target/debug/cnc872c.
//
//   node docs/images/view.mjs

import path from 'node:path';

import { launch, open, page, root, run } from '../../web/browser/chromium.mjs';

process.chdir(root);
const image = (name) => path.join('docs/images', name);
const FLANGE = 'samples/ok/flange.nc';
const CONTOUR = 'docs/guide/examples/contour/contour.nc';

for (const [program, name, ...options] of [
  [FLANGE, 'view-iso.svg', '--plane', 'iso'],
  [CONTOUR, 'view-dots.svg', '--plane', 'XY'],
]) {
  const done = run('view', program, '-o', image(name), '--size', '1000x640', ...options);
  if (done.status !== 0) {
    throw new Error(done.stderr);
  }
}

const browser = await launch();
for (const [scheme, locale, program, seq, by] of [
  ['light', 'en-GB', FLANGE, 44, 'motion'],
  ['dark', 'cs-CZ', CONTOUR, 8, 'velocity'],
]) {
  const { tab, close } = await open(browser, path.resolve(page(program)), { scheme, locale });
  await tab.evaluate(([seq, by]) => {
    window.cnc872c.colour(by);
    window.cnc872c.select(seq);
  }, [seq, by]);
  await tab.waitForTimeout(500);
  await tab.screenshot({ path: image(`view-${scheme}.png`) });
  await close();
}
await browser.close();

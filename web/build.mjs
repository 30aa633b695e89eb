// Builds the viewer: one script and one sheet of styles, which the Rust program embeds. They are committed, so that
// `cargo build` needs no npm; `./ci` proves them current.
//
//   node build.mjs            writes ../src/view/viewer
//   node build.mjs --check    fails when what is there differs

import { readFileSync, writeFileSync, mkdirSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

import { build } from 'esbuild';

const here = path.dirname(fileURLToPath(import.meta.url));
const out = path.join(here, '../src/view/viewer');

const result = await build({
  absWorkingDir: here,
  entryPoints: { viewer: 'src/main.ts' },
  outdir: out,
  bundle: true,
  minify: true,
  format: 'iife',
  target: ['chrome103', 'firefox113', 'safari16.4'],
  charset: 'ascii',
  legalComments: 'inline',
  logLevel: 'warning',
  write: false,
});

let stale = false;
for (const file of result.outputFiles) {
  // A page holds the files between tags.
  const text = file.text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
  const name = path.basename(file.path);
  if (process.argv.includes('--check')) {
    if (readFileSync(path.join(out, name), 'utf8') !== text) {
      console.error(`src/view/viewer/${name} is not what web/ gives: run node build.mjs in web/`);
      stale = true;
    }
  } else {
    mkdirSync(out, { recursive: true });
    writeFileSync(path.join(out, name), text);
    console.log(`${name}: ${Math.round(text.length / 1024)} kB`);
  }
}
process.exitCode = stale ? 1 : 0;

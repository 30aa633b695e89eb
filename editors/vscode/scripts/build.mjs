// Bundles the extension into dist/extension.js, with the licences of what goes in.
//
//   node scripts/build.mjs [--production] [--watch]

import { existsSync } from 'node:fs';
import { cp, readFile, readdir, writeFile } from 'node:fs/promises';
import path from 'node:path';

import esbuild from 'esbuild';

process.chdir(path.join(import.meta.dirname, '..'));
const production = process.argv.includes('--production');

const options = {
  entryPoints: ['src/extension.ts'],
  outfile: 'dist/extension.js',
  bundle: true,
  platform: 'node',
  format: 'cjs',
  target: 'node20',
  external: ['vscode'],
  minify: production,
  sourcemap: production ? false : 'linked',
  legalComments: 'none',
  metafile: true,
  logLevel: 'warning',
};

if (process.argv.includes('--watch')) {
  const context = await esbuild.context(options);
  await context.watch();
} else {
  const { metafile } = await esbuild.build(options);
  // The viewer of paths is that of the pages of `cnc872c view`.
  await cp('../../src/view/viewer', 'dist/viewer', { recursive: true });
  await writeFile('dist/THIRD-PARTY.txt', await licences(Object.keys(metafile.inputs)));
}

/** The licence texts of the packages that the files belong to. */
async function licences(files) {
  const folders = new Set();
  for (const file of files) {
    const match = /^(?:.*\/)?node_modules\/(?:@[^/]+\/)?[^/]+/.exec(file);
    if (match) {
      folders.add(match[0]);
    }
  }
  const texts = [];
  for (const folder of [...folders].sort()) {
    const { name, version, license } = JSON.parse(await readFile(path.join(folder, 'package.json'), 'utf8'));
    const file = (await readdir(folder)).find((entry) => /^licen[cs]e/i.test(entry));
    const text = file && existsSync(path.join(folder, file)) ? await readFile(path.join(folder, file), 'utf8') : '';
    texts.push(`${name} ${version} (${license})\n\n${text.trim()}\n`);
  }
  return texts.join(`\n${'-'.repeat(80)}\n\n`);
}

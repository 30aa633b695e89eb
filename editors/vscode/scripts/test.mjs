// Bundles the tests of test/NAME and runs them with node's test runner.
//
//   node scripts/test.mjs unit|grammar
//
// UPDATE=1 writes the snapshots of the grammar anew.

import { spawnSync } from 'node:child_process';
import { readdirSync, rmSync } from 'node:fs';
import path from 'node:path';

import esbuild from 'esbuild';

process.chdir(path.join(import.meta.dirname, '..'));
const [name = 'unit'] = process.argv.slice(2);
const folder = path.join('test', name);
const out = path.join('out', name);
const tests = readdirSync(folder).filter((file) => file.endsWith('.test.ts'));

rmSync(out, { recursive: true, force: true });
await esbuild.build({
  entryPoints: tests.map((file) => path.join(folder, file)),
  outdir: out,
  bundle: true,
  platform: 'node',
  format: 'cjs',
  target: 'node20',
  // Native and WebAssembly parts stay where they are.
  packages: 'external',
  logLevel: 'warning',
});
const files = tests.map((file) => path.join(out, file.replace(/\.ts$/, '.js')));
const { status } = spawnSync(process.execPath, ['--test', '--test-reporter=spec', ...files], { stdio: 'inherit' });
process.exit(status ?? 1);

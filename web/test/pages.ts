// Pages and streams of programs, made by the built program.

import { execFileSync, spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';

import { bytesOfText, Container, inflate } from '../src/data/columns.ts';
import type { Fields, Header } from '../src/data/header.ts';

export const root = path.resolve(process.cwd(), '..');
export const program = process.env['CNC872C'] ?? path.join(root, 'target/debug/cnc872c');

/** Programs among the samples that compile, in folders and alone. */
export function samples(): string[] {
  const found: string[] = [];
  const walk = (folder: string): void => {
    for (const name of readdirSync(folder).sort()) {
      const file = path.join(folder, name);
      if (statSync(file).isDirectory()) {
        walk(file);
      } else if (/\.nc$/i.test(name)) {
        found.push(file);
      }
    }
  };
  for (const folder of ['ok', 'projects', 'rules']) {
    walk(path.join(root, 'samples', folder));
  }
  return found;
}

/** The data of a page that the program writes. */
export async function pageData(file: string, ...options: string[]): Promise<Container<Header> | undefined> {
  const folder = mkdtempSync(path.join(tmpdir(), 'cnc872c-'));
  try {
    const page = path.join(folder, 'page.html');
    const run = spawnSync(program, ['view', file, '-o', page, '--format', 'short', ...options], { encoding: 'utf8' });
    if (run.status === 2) {
      return undefined;
    }
    return await dataOf(readFileSync(page, 'utf8'));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** The data that a page holds. */
export async function dataOf(page: string): Promise<Container<Header>> {
  const [, text] = /<script type="text\/plain" id="cnc872c-data">([^<]*)<\/script>/.exec(page)!;
  return new Container<Header>(await inflate(bytesOfText(text!)));
}

/** The set-up sheet; nothing when the program has errors. */
export function report(file: string): Fields | undefined {
  const run = spawnSync(program, ['report', file, '--format', 'json'], { encoding: 'utf8' });
  return run.status === 0 ? (JSON.parse(run.stdout) as Fields) : undefined;
}

/** The records of blocks of a stream; nothing when the program has errors. */
export function stream(command: string, file: string, ...options: string[]): Fields[] | undefined {
  try {
    const text = execFileSync(program, [command, file, ...options], {
      encoding: 'utf8',
      maxBuffer: 1 << 30,
      stdio: ['ignore', 'pipe', 'ignore'],
    });
    const lines = text.trimEnd().split('\n');
    return lines.map((line) => JSON.parse(line) as Fields).filter((record) => record['kind'] === 'block');
  } catch {
    return undefined;
  }
}

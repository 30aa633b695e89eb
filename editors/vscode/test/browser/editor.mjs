// VS Code in a browser: starts code-server with the packaged extension and a folder of programs, and Chromium.

import { spawn, spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import net from 'node:net';
import { tmpdir } from 'node:os';
import path from 'node:path';

import { chromium } from 'playwright-core';

const here = import.meta.dirname;
const extension = path.join(here, '../..');
const project = path.join(extension, '../..');
const entry = path.join(here, 'node_modules/code-server/out/node/entry.js');

/** Where screenshots go. */
export const PICTURES = path.join(here, 'run');

/** The server: $CNC872C, else the newer of the project's builds. */
export function serverProgram() {
  const builds = ['release', 'debug'].map((kind) => path.join(project, 'target', kind, 'cnc872c'));
  const program = process.env.CNC872C ?? builds.find((build) => existsSync(build));
  if (!program || !existsSync(program)) {
    throw new Error('no cnc872c: build it with cargo, or set CNC872C');
  }
  return program;
}

function freePort() {
  return new Promise((resolve, reject) => {
    const server = net.createServer();
    server.on('error', reject);
    server.listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}

async function answers(url, process) {
  for (let tries = 0; tries < 120; tries += 1) {
    if (process.exitCode !== null) {
      throw new Error(`code-server ended with ${process.exitCode}`);
    }
    const ok = await fetch(url).then(
      (response) => response.ok,
      () => false,
    );
    if (ok) {
      return;
    }
    await new Promise((resolve) => setTimeout(resolve, 250));
  }
  throw new Error('code-server does not answer');
}

/**
 * An editor with a folder: `files` names what of the project is copied there, by its name in the folder, or gives the
 * bytes; `language` is that of the extension's texts; `first` is a file that is open from the start.
 */
export async function openEditor({ files, settings, language, first }) {
  const place = mkdtempSync(path.join(tmpdir(), 'cnc872c-browser-'));
  const [data, extensions, folder, profile] = ['data', 'extensions', 'programs', 'profile'].map((name) =>
    path.join(place, name),
  );
  mkdirSync(path.join(data, 'User'), { recursive: true });
  mkdirSync(folder);
  for (const [name, source] of Object.entries(files)) {
    if (Buffer.isBuffer(source)) {
      writeFileSync(path.join(folder, name), source);
    } else {
      cpSync(path.join(project, source), path.join(folder, name), { recursive: true });
    }
  }
  const quiet = {
    'workbench.startupEditor': 'none',
    'workbench.enableExperiments': false,
    'workbench.tips.enabled': false,
    'workbench.layoutControl.enabled': false,
    'workbench.secondarySideBar.defaultVisibility': 'hidden',
    'chat.commandCenter.enabled': false,
    'window.commandCenter': false,
    'security.workspace.trust.enabled': false,
    'telemetry.telemetryLevel': 'off',
    'update.mode': 'none',
    'extensions.autoCheckUpdates': false,
    'extensions.ignoreRecommendations': true,
    'editor.minimap.enabled': false,
    'editor.cursorBlinking': 'solid',
    'workbench.colorTheme': 'Default Light Modern',
    'git.enabled': false,
    'files.autoSave': 'off',
  };
  writeFileSync(path.join(data, 'User/settings.json'), JSON.stringify({ ...quiet, ...settings }, null, 2));
  const vsix = readdirSync(extension).find((file) => /^cnc872c-.*\.vsix$/.test(file));
  if (!vsix) {
    throw new Error('no .vsix: npm run package');
  }
  const common = ['--user-data-dir', data, '--extensions-dir', extensions, '--config', path.join(place, 'config.yaml')];
  const installed = spawnSync(process.execPath, [entry, ...common, '--install-extension', path.join(extension, vsix)], {
    encoding: 'utf8',
  });
  if (installed.status !== 0) {
    throw new Error(`the extension cannot be installed: ${installed.stdout}${installed.stderr}`);
  }
  const port = await freePort();
  const quietly = [
    '--disable-telemetry',
    '--disable-update-check',
    '--disable-workspace-trust',
    '--disable-getting-started-override',
  ];
  const server = spawn(
    process.execPath,
    [entry, ...common, '--auth', 'none', '--bind-addr', `127.0.0.1:${port}`, ...quietly],
    { stdio: 'ignore', detached: true, env: { ...process.env, VSCODE_PROXY_URI: '' } },
  );
  const url = `http://127.0.0.1:${port}`;
  let browser;
  const close = async () => {
    await browser?.close();
    try {
      process.kill(-server.pid, 'SIGTERM');
    } catch {
      // It has ended by itself.
    }
    rmSync(place, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  };
  try {
    await answers(`${url}/healthz`, server);
    browser = await chromium.launchPersistentContext(profile, {
      executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
      headless: true,
      args: [
        '--no-sandbox',
        '--disable-gpu',
        '--disable-quic',
        '--no-first-run',
        '--disable-background-networking',
        '--disable-component-update',
        '--disable-sync',
      ],
      viewport: { width: 1200, height: 760 },
      locale: 'en-US',
    });
    const page = browser.pages()[0] ?? (await browser.newPage());
    if (language !== undefined) {
      // What a language pack would set: the extension's own texts are then in that language, the editor's stay English.
      await page.addInitScript((value) => {
        Object.defineProperty(globalThis, '_VSCODE_NLS_LANGUAGE', { get: () => value, set: () => {} });
      }, language);
    }
    const place = `vscode-remote://127.0.0.1:${port}${path.join(folder, first ?? '')}`;
    const opens = first === undefined ? '' : `&payload=${encodeURIComponent(JSON.stringify([['openFile', place]]))}`;
    await page.goto(`${url}/?folder=${encodeURIComponent(folder)}${opens}`);
    await page.waitForSelector('.monaco-workbench .part.editor', { timeout: 60_000 });
    return { page, folder, close, editor: new Editor(page) };
  } catch (error) {
    await close();
    throw error;
  }
}

/** What a user does. */
class Editor {
  constructor(page) {
    this.page = page;
  }

  async openFile(name) {
    await this.page.locator('.explorer-folders-view .monaco-list-row', { hasText: name }).first().dblclick();
    await this.page.waitForSelector(`.tab.active[data-resource-name="${name}"]`, { timeout: 20_000 });
    await this.page.locator('.editor-group-container.active .monaco-editor .view-line').first().waitFor();
  }

  async command(title) {
    await this.quickInput('F1', title);
  }

  /** Types into the input that the key opens, and takes the first entry that has the text. */
  async quickInput(key, text) {
    const { page } = this;
    const input = page.locator('.quick-input-widget:visible input.input');
    const open = async (timeout) => {
      await page.keyboard.press(key);
      await input.waitFor({ timeout });
      await input.fill(key === 'F1' ? `>${text}` : text, { timeout });
      await page.locator('.quick-input-list .monaco-list-row', { hasText: text }).first().waitFor({ timeout });
    };
    // An editor that takes the focus late closes the input again.
    await open(5_000).catch(() => open(20_000));
    await page.waitForTimeout(200);
    await page.keyboard.press('Enter');
  }

  /** Puts the cursor at line and column, both from 1. */
  async goTo(line, column = 1) {
    const { page } = this;
    await page.keyboard.press('Control+KeyG');
    const input = page.locator('.quick-input-widget:visible input.input');
    await input.waitFor();
    await input.fill(`:${line}:${column}`);
    await page.keyboard.press('Enter');
    await page.waitForTimeout(200);
  }

  async picture(name) {
    mkdirSync(PICTURES, { recursive: true });
    await this.page.mouse.move(1199, 400);
    await this.page.waitForTimeout(300);
    await this.page.screenshot({ path: path.join(PICTURES, `${name}.png`) });
  }
}

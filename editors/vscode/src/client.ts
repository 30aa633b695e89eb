// The language server and the client that talks to it: start, stop, restart, settings.

import { constants, accessSync, statSync } from 'node:fs';
import { homedir } from 'node:os';

import * as vscode from 'vscode';
import {
  type ClientCapabilities,
  type FeatureState,
  LanguageClient,
  type LanguageClientOptions,
  RevealOutputChannelOn,
  State,
  type StaticFeature,
} from 'vscode-languageclient/node';

import { type Found, findServer } from './server';
import { serverSettings } from './settings';

const SECTION = 'cnc872c';

/** A ChannelConfig is read while it is typed; which file it is, the project file says. */
const CHANNEL_CONFIG = { scheme: 'file', pattern: '**/*.xml' };

/** The command of code lenses and hints that the client carries out (LSP has none for it). */
export const SHOW_REFERENCES = 'cnc872c.showReferences';

/** The command of code lenses above tool changes. */
export const STATE_HERE = 'cnc872c.stateHere';

/** Tells the server which commands it may put into lenses and hints. */
class ClientCommands implements StaticFeature {
  getState(): FeatureState {
    return { kind: 'static' };
  }

  fillClientCapabilities(capabilities: ClientCapabilities): void {
    const experimental = (capabilities.experimental ?? {}) as Record<string, unknown>;
    capabilities.experimental = { ...experimental, commands: { commands: [SHOW_REFERENCES, STATE_HERE] } };
  }

  initialize(): void {
    // Nothing to register: the command is the extension's own.
  }

  clear(): void {
    // Nothing was registered.
  }
}

/** The server with its client, and what the user sees of its state. */
export class Server implements vscode.Disposable {
  readonly output = vscode.window.createOutputChannel('CNC872', { log: true });
  private readonly status = vscode.languages.createLanguageStatusItem('cnc872c.server', documents());
  private readonly subscriptions: vscode.Disposable[] = [];
  private running: LanguageClient | undefined;
  /** Starts and stops follow one another, never overlap. */
  private queue: Promise<void> = Promise.resolve();

  constructor(private readonly context: vscode.ExtensionContext) {
    this.status.name = 'CNC872';
    this.status.command = { command: 'cnc872c.showOutput', title: vscode.l10n.t('Show Output') };
    this.subscriptions.push(
      this.output,
      this.status,
      vscode.workspace.onDidChangeConfiguration((event) => this.configurationChanged(event)),
      vscode.workspace.onDidGrantWorkspaceTrust(() => this.restart()),
    );
  }

  dispose(): void {
    for (const subscription of this.subscriptions) {
      subscription.dispose();
    }
  }

  /** The client, once the server runs. */
  get client(): LanguageClient | undefined {
    return this.running?.state === State.Running ? this.running : undefined;
  }

  start(): Promise<void> {
    return this.enqueue(() => this.startNow());
  }

  stop(): Promise<void> {
    return this.enqueue(() => this.stopNow());
  }

  restart(): Promise<void> {
    return this.enqueue(async () => {
      await this.stopNow();
      await this.startNow();
    });
  }

  private enqueue(work: () => Promise<void>): Promise<void> {
    this.queue = this.queue.then(work).catch((error: unknown) => {
      this.output.error(String(error));
    });
    return this.queue;
  }

  private async startNow(): Promise<void> {
    const configuration = vscode.workspace.getConfiguration(SECTION);
    const found = find(this.context, configuration.get<string | null>('server.path'));
    if (found.kind !== 'found') {
      this.report(found);
      return;
    }
    const extra = configuration.get<string[]>('server.arguments') ?? [];
    this.output.info(`${found.program} lsp ${extra.join(' ')}`.trimEnd());
    const client = new LanguageClient(
      SECTION,
      'CNC872',
      { command: found.program, args: ['lsp', ...extra] },
      this.options(),
    );
    client.registerFeature(new ClientCommands());
    client.onDidChangeState(({ newState }) => this.show(client, newState));
    this.running = client;
    try {
      await client.start();
    } catch (error) {
      // The client has said it in its own words; the extension goes on without a server.
      this.output.error(String(error));
      this.status.text = vscode.l10n.t('The language server did not start');
      this.status.severity = vscode.LanguageStatusSeverity.Error;
    }
  }

  private async stopNow(): Promise<void> {
    const client = this.running;
    this.running = undefined;
    if (client === undefined) {
      return;
    }
    try {
      await client.dispose();
    } catch (error) {
      this.output.warn(String(error));
    }
  }

  private options(): LanguageClientOptions {
    return {
      documentSelector: [...documents(), { scheme: 'file', pattern: '**/cnc872c.toml' }, CHANNEL_CONFIG],
      initializationOptions: settings(undefined),
      outputChannel: this.output,
      revealOutputChannelOn: RevealOutputChannelOn.Never,
      synchronize: { configurationSection: SECTION },
      middleware: {
        workspace: {
          configuration: async (params, token, next) => {
            const answers = await next(params, token);
            if (!Array.isArray(answers)) {
              return answers;
            }
            return answers.map((answer: unknown, index) => {
              const item = params.items[index];
              return item?.section === SECTION ? settings(item.scopeUri) : answer;
            });
          },
        },
        provideInlayHints: (document, range, token, next) =>
          vscode.workspace.getConfiguration(SECTION).get('inlayHints', true) ? next(document, range, token) : [],
      },
    };
  }

  private configurationChanged(event: vscode.ConfigurationChangeEvent): void {
    if (event.affectsConfiguration(`${SECTION}.server`)) {
      void this.restart();
    } else if (event.affectsConfiguration(`${SECTION}.inlayHints`)) {
      const feature = this.client?.getFeature('textDocument/inlayHint');
      for (const editor of vscode.window.visibleTextEditors) {
        feature?.getProvider(editor.document)?.onDidChangeInlayHints.fire();
      }
    }
  }

  private show(client: LanguageClient, state: State): void {
    const info = client.initializeResult?.serverInfo;
    this.status.busy = state === State.Starting;
    this.status.severity =
      state === State.Stopped ? vscode.LanguageStatusSeverity.Warning : vscode.LanguageStatusSeverity.Information;
    if (state === State.Running) {
      this.status.text = info === undefined ? 'cnc872c' : `${info.name} ${info.version ?? ''}`.trimEnd();
    } else if (state === State.Starting) {
      this.status.text = vscode.l10n.t('The language server is starting');
    } else {
      this.status.text = vscode.l10n.t('The language server is not running');
    }
  }

  /** Says that there is no server, and what to do. */
  private report(found: Exclude<Found, { kind: 'found' }>): void {
    const text =
      found.kind === 'wrong-setting'
        ? vscode.l10n.t(
            'The program {0}, which the setting "cnc872c.server.path" names, cannot be run. Until this is fixed, programs are coloured but not checked.',
            found.program,
          )
        : vscode.l10n.t(
            'The program cnc872c was not found. Install it, or set "cnc872c.server.path" to where it is. Until then, programs are coloured but not checked.',
          );
    this.output.warn(text);
    this.status.text = vscode.l10n.t('cnc872c was not found');
    this.status.severity = vscode.LanguageStatusSeverity.Error;
    const settings = vscode.l10n.t('Open Settings');
    void vscode.window.showErrorMessage(text, settings).then((chosen) => {
      if (chosen === settings) {
        void vscode.commands.executeCommand('workbench.action.openSettings', 'cnc872c.server.path');
      }
    });
  }
}

/** The programs that the server is told of. */
export function documents(): { language: string; scheme: string }[] {
  return [
    { language: 'cnc872', scheme: 'file' },
    { language: 'cnc872', scheme: 'untitled' },
  ];
}

/** The server's settings for a document or folder. */
function settings(scope: string | undefined) {
  const uri = scope === undefined ? vscode.workspace.workspaceFolders?.[0]?.uri : vscode.Uri.parse(scope);
  const configuration = vscode.workspace.getConfiguration(SECTION, uri ?? null);
  return serverSettings((name) => configuration.get(name));
}

function find(context: vscode.ExtensionContext, setting: string | null | undefined): Found {
  const machine = { platform: process.platform, env: process.env, home: homedir(), isProgram };
  const workspace = vscode.workspace.workspaceFolders?.find((folder) => folder.uri.scheme === 'file')?.uri.fsPath;
  return findServer({ setting, extension: context.extensionPath, workspace }, machine);
}

function isProgram(file: string): boolean {
  try {
    if (process.platform !== 'win32') {
      accessSync(file, constants.X_OK);
    }
    return statSync(file).isFile();
  } catch {
    return false;
  }
}

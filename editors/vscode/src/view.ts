// The read-only views of a program's block stream, of the PLC signals of a block, and of the state there.

import * as vscode from 'vscode';

import type { Server } from './client';
import { type Stream, asStream, blocks, signalsPath, viewPath } from './stream';

const SCHEME = 'cnc872c-stream';

/** Shows block streams and signals beside their programs; what is shown again replaces what was shown. */
export class Views implements vscode.TextDocumentContentProvider, vscode.Disposable {
  private readonly changed = new vscode.EventEmitter<vscode.Uri>();
  private readonly texts = new Map<string, string>();
  private readonly subscriptions: vscode.Disposable[];
  readonly onDidChange = this.changed.event;

  constructor(private readonly server: Server) {
    this.subscriptions = [
      this.changed,
      vscode.workspace.registerTextDocumentContentProvider(SCHEME, this),
      vscode.workspace.onDidCloseTextDocument((document) => this.texts.delete(document.uri.toString())),
    ];
  }

  dispose(): void {
    for (const subscription of this.subscriptions) {
      subscription.dispose();
    }
  }

  provideTextDocumentContent(uri: vscode.Uri): string {
    return this.texts.get(uri.toString()) ?? '';
  }

  async showStream(program: vscode.Uri): Promise<void> {
    const request = { command: 'cnc872c.stream', arguments: [program.toString()] };
    const title = vscode.l10n.t('Expanding the program into its block stream');
    const answer = await this.ask('workspace/executeCommand', request, title);
    if (answer === undefined) {
      return;
    }
    if (answer === null) {
      void vscode.window.showErrorMessage(vscode.l10n.t('The server gave no block stream for this program'));
      return;
    }
    const document = await this.open(viewPath(program.path), program, answer.text);
    await show(document.languageId === 'jsonl' ? document : await inJsonLines(document));
    if (answer.truncated) {
      void vscode.window.showInformationMessage(
        vscode.l10n.t(
          'The stream is shown up to block {0}. The whole of it: cnc872c compile FILE -o FILE.jsonl',
          blocks(answer.text),
        ),
      );
    }
  }

  /** What the PLC reads in the block at a place. */
  async showSignals(program: vscode.Uri, place: vscode.Position): Promise<void> {
    const request = {
      textDocument: { uri: program.toString() },
      position: { line: place.line, character: place.character },
    };
    const answer = await this.ask('cnc872c/signals', request, vscode.l10n.t('Looking at the PLC signals of the block'));
    if (answer === null) {
      void vscode.window.showInformationMessage(vscode.l10n.t('There is no block here'));
    } else if (answer !== undefined) {
      await show(await this.open(signalsPath(program.path), program, answer.text));
      if (answer.truncated) {
        void vscode.window.showInformationMessage(
          vscode.l10n.t('Not all runs of the block are shown. All of them: cnc872c plc FILE'),
        );
      }
    }
  }

  /** Shows a text that belongs to a program, under that name. */
  async showText(path: string, program: vscode.Uri, text: string): Promise<void> {
    await show(await this.open(path, program, text));
  }

  /** The answer of the server; null when it is none, undefined when it is an error, which the user has seen. */
  private async ask(method: string, request: object, title: string): Promise<Stream | null | undefined> {
    const client = this.server.client;
    if (client === undefined) {
      void vscode.window.showWarningMessage(vscode.l10n.t('The language server is not running'));
      return undefined;
    }
    return vscode.window.withProgress({ location: vscode.ProgressLocation.Window, title }, () =>
      client.sendRequest(method, request).then(
        (answer) => asStream(answer) ?? null,
        (error: unknown) => {
          void vscode.window.showErrorMessage(error instanceof Error ? error.message : String(error));
          return undefined;
        },
      ),
    );
  }

  private async open(path: string, program: vscode.Uri, text: string): Promise<vscode.TextDocument> {
    const view = vscode.Uri.from({ scheme: SCHEME, path, query: program.toString() });
    this.texts.set(view.toString(), text);
    this.changed.fire(view);
    return vscode.workspace.openTextDocument(view);
  }
}

async function show(document: vscode.TextDocument): Promise<void> {
  await vscode.window.showTextDocument(document, { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true });
}

/** The document as JSON Lines where the editor knows them, else as it is. */
async function inJsonLines(document: vscode.TextDocument): Promise<vscode.TextDocument> {
  const languages = await vscode.languages.getLanguages();
  return languages.includes('jsonl') ? vscode.languages.setTextDocumentLanguage(document, 'jsonl') : document;
}

// The read-only view of a program's block stream.

import * as vscode from 'vscode';

import type { Server } from './client';
import { asStream, blocks, viewPath } from './stream';

const SCHEME = 'cnc872c-stream';

/** Shows block streams beside their programs; a stream shown again replaces what was shown. */
export class StreamView implements vscode.TextDocumentContentProvider, vscode.Disposable {
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

  async show(program: vscode.Uri): Promise<void> {
    const client = this.server.client;
    if (client === undefined) {
      void vscode.window.showWarningMessage(vscode.l10n.t('The language server is not running'));
      return;
    }
    const request = { command: 'cnc872c.stream', arguments: [program.toString()] };
    const title = vscode.l10n.t('Expanding the program into its block stream');
    const answer = await vscode.window.withProgress({ location: vscode.ProgressLocation.Window, title }, () =>
      client.sendRequest('workspace/executeCommand', request).then(asStream, (error: unknown) => {
        void vscode.window.showErrorMessage(error instanceof Error ? error.message : String(error));
        return null;
      }),
    );
    if (answer === null) {
      return;
    }
    if (answer === undefined) {
      void vscode.window.showErrorMessage(vscode.l10n.t('The server gave no block stream for this program'));
      return;
    }
    const view = vscode.Uri.from({ scheme: SCHEME, path: viewPath(program.path), query: program.toString() });
    this.texts.set(view.toString(), answer.text);
    this.changed.fire(view);
    const document = await vscode.workspace.openTextDocument(view);
    const shown = document.languageId === 'jsonl' ? document : await inJsonLines(document);
    await vscode.window.showTextDocument(shown, { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true });
    if (answer.truncated) {
      void vscode.window.showInformationMessage(
        vscode.l10n.t(
          'The stream is shown up to block {0}. The whole of it: cnc872c compile FILE -o FILE.jsonl',
          blocks(answer.text),
        ),
      );
    }
  }
}

/** The document as JSON Lines where the editor knows them, else as it is. */
async function inJsonLines(document: vscode.TextDocument): Promise<vscode.TextDocument> {
  const languages = await vscode.languages.getLanguages();
  return languages.includes('jsonl') ? vscode.languages.setTextDocumentLanguage(document, 'jsonl') : document;
}

// The dots that the control draws at joints of motions: yellow where motion goes on, red where it stops or is slow.

import * as vscode from 'vscode';

import type { Server } from './client';
import { type Dot, asDots } from './stream';

const SETTING = 'motion.dots';
/** Milliseconds without a change before the server is asked. */
const QUIET = 500;

/** Shows dots behind the blocks of the programs that are seen, while the setting is on. */
export class Dots implements vscode.Disposable {
  private readonly kinds = { yellow: kind('charts.yellow'), red: kind('charts.red') };
  private readonly subscriptions: vscode.Disposable[];
  private timer: NodeJS.Timeout | undefined;

  constructor(private readonly server: Server) {
    this.subscriptions = [
      this.kinds.yellow,
      this.kinds.red,
      vscode.window.onDidChangeVisibleTextEditors(() => this.soon()),
      vscode.workspace.onDidChangeTextDocument(() => this.soon()),
      vscode.workspace.onDidChangeConfiguration((event) => {
        if (event.affectsConfiguration(`cnc872c.${SETTING}`)) {
          this.soon();
        }
      }),
    ];
    this.soon();
  }

  dispose(): void {
    clearTimeout(this.timer);
    for (const subscription of this.subscriptions) {
      subscription.dispose();
    }
  }

  private soon(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.show(), QUIET);
  }

  private async show(): Promise<void> {
    for (const editor of vscode.window.visibleTextEditors) {
      if (editor.document.languageId === 'cnc872') {
        const { version } = editor.document;
        const dots = await this.ask(editor.document);
        // What came for an older text would stand at wrong lines.
        if (editor.document.version === version) {
          this.draw(editor, dots);
        }
      }
    }
  }

  private async ask(document: vscode.TextDocument): Promise<readonly Dot[]> {
    const client = this.server.client;
    if (client === undefined || !vscode.workspace.getConfiguration('cnc872c', document).get(SETTING, false)) {
      return [];
    }
    const request = { textDocument: { uri: document.uri.toString() } };
    return client.sendRequest('cnc872c/dots', request).then(asDots, () => []);
  }

  private draw(editor: vscode.TextEditor, dots: readonly Dot[]): void {
    for (const name of ['yellow', 'red'] as const) {
      const lines = dots.filter(({ line, dot }) => dot === name && line < editor.document.lineCount);
      const places = lines.map(({ line }) => editor.document.lineAt(line).range);
      editor.setDecorations(this.kinds[name], places);
    }
  }
}

function kind(color: string): vscode.TextEditorDecorationType {
  const margin = '0 0 0 1em';
  return vscode.window.createTextEditorDecorationType({
    after: { contentText: '●', color: new vscode.ThemeColor(color), margin },
    isWholeLine: true,
  });
}

// The path of the program in hand, in a panel beside its text.

import { randomBytes } from 'node:crypto';

import * as vscode from 'vscode';

import type { Server } from './client';
import { type Path, type Place, asPath, asSelected, pageOf } from './path';
import { language } from './settings';

/** Milliseconds without a change before the server is asked; after a slow answer as long as that took. */
const QUIET = 250;
/** For so many milliseconds after the panel moved the cursor, moves that no key or mouse makes are taken for its own. */
const OWN = 500;

/** The panel that shows paths: one for all programs, as a preview is. */
export class PathPanel implements vscode.Disposable {
  private panel: vscode.WebviewPanel | undefined;
  private readonly subscriptions: vscode.Disposable[];
  private timer: NodeJS.Timeout | undefined;
  /** Whether the page can take messages. */
  private ready = false;
  /** The program or macrocycle that was asked about last. */
  private asked: vscode.Uri | undefined;
  private path: Path | undefined;
  private asking: vscode.CancellationTokenSource | undefined;
  private took = 0;
  private moved = 0;

  constructor(
    private readonly server: Server,
    private readonly extension: vscode.Uri,
  ) {
    this.subscriptions = [
      vscode.window.onDidChangeTextEditorSelection((event) => this.follow(event)),
      vscode.window.onDidChangeActiveTextEditor((editor) => this.changeProgram(editor)),
      vscode.workspace.onDidChangeTextDocument((event) => {
        if (this.shows(event.document.uri)) {
          this.soon();
        }
      }),
    ];
  }

  dispose(): void {
    clearTimeout(this.timer);
    this.panel?.dispose();
    for (const subscription of this.subscriptions) {
      subscription.dispose();
    }
  }

  /** Shows the path of a program, or of the program that calls a macrocycle. */
  async show(editor: vscode.TextEditor): Promise<void> {
    const column = vscode.ViewColumn.Beside;
    if (this.panel === undefined) {
      this.open(column);
    } else {
      this.panel.reveal(undefined, true);
    }
    await this.ask(editor.document.uri);
  }

  private open(column: vscode.ViewColumn): void {
    const viewer = vscode.Uri.joinPath(this.extension, 'dist', 'viewer');
    const panel = vscode.window.createWebviewPanel(
      'cnc872c.path',
      vscode.l10n.t('Path'),
      { viewColumn: column, preserveFocus: true },
      { enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [viewer] },
    );
    const { webview } = panel;
    panel.iconPath = vscode.Uri.joinPath(this.extension, 'images', 'icon.png');
    panel.onDidDispose(() => {
      this.asking?.cancel();
      this.panel = undefined;
      this.path = undefined;
      this.ready = false;
    });
    webview.onDidReceiveMessage((message: unknown) => void this.receive(message));
    const file = (name: string): string => webview.asWebviewUri(vscode.Uri.joinPath(viewer, name)).toString();
    const setting = vscode.workspace.getConfiguration('cnc872c').get('language');
    webview.html = pageOf(
      { script: file('viewer.js'), styles: file('viewer.css'), source: webview.cspSource },
      randomBytes(16).toString('hex'),
      language(setting, vscode.env.language),
    );
    this.panel = panel;
  }

  /** Whether a document is among the files of the path. */
  private shows(uri: vscode.Uri): boolean {
    return this.panel !== undefined && (this.index(uri) >= 0 || uri.toString() === this.asked?.toString());
  }

  private index(uri: vscode.Uri): number {
    const name = uri.toString();
    return this.path?.files.findIndex((file) => file !== undefined && vscode.Uri.parse(file).toString() === name) ?? -1;
  }

  /** The program that is worked on now is shown. */
  private changeProgram(editor: vscode.TextEditor | undefined): void {
    if (editor?.document.languageId === 'cnc872' && this.panel !== undefined && !this.shows(editor.document.uri)) {
      void this.ask(editor.document.uri);
    }
  }

  private soon(): void {
    clearTimeout(this.timer);
    const { asked } = this;
    this.timer = setTimeout(() => asked && void this.ask(asked), Math.max(QUIET, this.took));
  }

  /** Asks for the path of a program and shows it; of a macrocycle that no open program calls, what is shown stays. */
  private async ask(uri: vscode.Uri): Promise<void> {
    const client = this.server.client;
    if (client === undefined) {
      void vscode.window.showWarningMessage(vscode.l10n.t('The language server is not running'));
      return;
    }
    this.asking?.cancel();
    const asking = new vscode.CancellationTokenSource();
    this.asking = asking;
    const begun = Date.now();
    const request = { textDocument: { uri: uri.toString() } };
    const answer = await client.sendRequest('cnc872c/path', request, asking.token).then(asPath, (error: unknown) => {
      if (!asking.token.isCancellationRequested) {
        this.server.output.error(String(error));
      }
      return undefined;
    });
    if (asking.token.isCancellationRequested || this.panel === undefined) {
      return;
    }
    this.took = Date.now() - begun;
    if (answer !== undefined) {
      this.take(answer, uri);
    } else if (this.path === undefined) {
      void vscode.window.showInformationMessage(vscode.l10n.t('No open program calls this macrocycle'));
    }
  }

  private take(path: Path, uri: vscode.Uri): void {
    const before = this.path;
    this.asked = uri;
    if (this.panel !== undefined) {
      this.panel.title = `${vscode.l10n.t('Path')}: ${path.uri.split('/').pop() ?? ''}`;
    }
    // While a block is typed the program may be none for a moment: what was drawn last stays.
    if (path.blocks === 0 && before !== undefined && before.uri === path.uri && before.blocks > 0) {
      this.post({ cnc872c: 'stale' });
      return;
    }
    this.path = path;
    this.send();
    if (path.truncated && before?.uri !== path.uri) {
      const text = vscode.l10n.t('The path is shown up to block {0}. All of it: cnc872c view FILE', path.blocks - 1);
      void vscode.window.showInformationMessage(text);
    }
  }

  private send(): void {
    if (this.path !== undefined) {
      const { data } = this.path;
      this.post({ cnc872c: 'data', data, place: this.cursor(vscode.window.activeTextEditor) });
    }
  }

  private post(message: object): void {
    if (this.ready) {
      void this.panel?.webview.postMessage(message);
    }
  }

  private async receive(message: unknown): Promise<void> {
    if ((message as { cnc872c?: unknown } | null)?.cnc872c === 'ready') {
      this.ready = true;
      this.send();
      return;
    }
    const place = asSelected(message);
    const file = place && this.path?.files[place.file];
    if (place !== undefined && file !== undefined) {
      await this.moveCursor(vscode.Uri.parse(file), place.line - 1);
    }
  }

  /** Puts the cursor at a line: in the editor of the file, which opens where the program's is. */
  private async moveCursor(uri: vscode.Uri, line: number): Promise<void> {
    const open = vscode.window.visibleTextEditors;
    const own = open.find((editor) => editor.document.uri.toString() === uri.toString());
    const other = open.find((editor) => this.index(editor.document.uri) >= 0);
    const document = own?.document ?? (await vscode.workspace.openTextDocument(uri));
    if (line >= document.lineCount) {
      return;
    }
    this.moved = Date.now();
    const at = document.lineAt(line).range.start;
    const selection = new vscode.Range(at, at);
    const viewColumn = own?.viewColumn ?? other?.viewColumn ?? vscode.ViewColumn.One;
    await vscode.window.showTextDocument(document, { viewColumn, preserveFocus: true, selection });
  }

  /** Tells the page where the cursor is. */
  private follow(event: vscode.TextEditorSelectionChangeEvent): void {
    if (this.panel === undefined || (event.kind === undefined && Date.now() - this.moved < OWN)) {
      return;
    }
    const place = this.cursor(event.textEditor);
    if (place !== undefined) {
      this.post({ cnc872c: 'cursor', place });
    }
  }

  private cursor(editor: vscode.TextEditor | undefined): Place | undefined {
    const file = editor === undefined ? -1 : this.index(editor.document.uri);
    return editor === undefined || file < 0 ? undefined : { file, line: editor.selection.active.line + 1 };
  }
}

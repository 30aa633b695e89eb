// What a program does otherwise than its saved text, or than another program: the page of `cnc872c compare`, in a panel.

import * as vscode from 'vscode';

import type { Server } from './client';

/** What the server's request `cnc872c/compare` answers. */
interface Answer {
  readonly same?: unknown;
  readonly page?: unknown;
}

/** Compares an open program with its saved text. */
export async function compareWithSaved(server: Server, program: vscode.TextDocument): Promise<void> {
  if (!program.isDirty) {
    void vscode.window.showInformationMessage(vscode.l10n.t('The program has no changes that are not saved'));
    return;
  }
  await compare(server, program.uri, undefined);
}

/** Compares an open program with another file, which is asked for; that one is the old one. */
export async function compareWithFile(server: Server, program: vscode.TextDocument): Promise<void> {
  const chosen = await vscode.window.showOpenDialog({
    defaultUri: vscode.Uri.joinPath(program.uri, '..'),
    openLabel: vscode.l10n.t('Compare'),
    title: vscode.l10n.t('The old program'),
  });
  const [other] = chosen ?? [];
  if (other !== undefined) {
    await compare(server, program.uri, other);
  }
}

async function compare(server: Server, uri: vscode.Uri, other: vscode.Uri | undefined): Promise<void> {
  const { client } = server;
  if (client === undefined) {
    void vscode.window.showWarningMessage(vscode.l10n.t('The language server is not running'));
    return;
  }
  const request = { textDocument: { uri: uri.toString() }, with: other?.toString(), page: true };
  let answer: Answer | null;
  try {
    answer = await client.sendRequest<Answer | null>('cnc872c/compare', request);
  } catch (error) {
    // The server says why in the language of the user.
    void vscode.window.showWarningMessage(error instanceof Error ? error.message : String(error));
    return;
  }
  if (answer?.same === true) {
    void vscode.window.showInformationMessage(vscode.l10n.t('The programs do the same'));
  } else if (typeof answer?.page === 'string') {
    const name = uri.path.split('/').pop() ?? '';
    const title = `${vscode.l10n.t('Changes')}: ${name}`;
    const panel = vscode.window.createWebviewPanel('cnc872c.changes', title, vscode.ViewColumn.Beside, {
      enableScripts: true,
      retainContextWhenHidden: true,
      localResourceRoots: [],
    });
    panel.webview.html = answer.page;
  }
}

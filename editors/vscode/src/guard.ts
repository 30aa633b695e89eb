// A program that was read in a wrong code page must not be saved in it.

import * as vscode from 'vscode';

import { CODE_PAGES, isDamaged } from './encoding';

/** Looks at each program when it is opened, and offers to read it again. */
export function guardEncodings(): vscode.Disposable {
  const asked = new Set<string>();
  const look = (document: vscode.TextDocument) => {
    const key = document.uri.toString();
    const concerns = document.languageId === 'cnc872' && document.uri.scheme === 'file' && !asked.has(key);
    if (concerns && isDamaged(document.getText())) {
      asked.add(key);
      void ask(document);
    }
  };
  vscode.workspace.textDocuments.forEach(look);
  return vscode.Disposable.from(
    vscode.workspace.onDidOpenTextDocument(look),
    vscode.workspace.onDidCloseTextDocument((document) => asked.delete(document.uri.toString())),
  );
}

async function ask(document: vscode.TextDocument): Promise<void> {
  const others = CODE_PAGES.filter((page) => page.id !== document.encoding);
  const chosen = await vscode.window.showWarningMessage(
    vscode.l10n.t(
      '{0} was read as {1}, but is in another code page. Saving it now would destroy letters in its comments. Read it again as:',
      vscode.workspace.asRelativePath(document.uri),
      document.encoding,
    ),
    ...others.map((page) => page.label),
  );
  const page = others.find(({ label }) => label === chosen);
  if (page === undefined) {
    return;
  }
  try {
    await vscode.workspace.openTextDocument(document.uri, { encoding: page.id });
  } catch (error) {
    // A program with unsaved changes cannot be read again.
    void vscode.window.showErrorMessage(error instanceof Error ? error.message : String(error));
  }
}

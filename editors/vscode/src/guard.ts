// A program that was read in a wrong code page must not be saved in it.

import * as vscode from 'vscode';

import { CODE_PAGES, again, isDamaged } from './encoding';

/**
 * Looks at each program when it is opened. One that the editor took for UTF-8, because its name did not say that it is a
 * program or because the editor was still starting, is read again as the settings say; else the user is asked.
 */
export function guardEncodings(): vscode.Disposable {
  const seen = new Set<string>();
  const look = (document: vscode.TextDocument) => {
    const key = document.uri.toString();
    const concerns = document.languageId === 'cnc872' && document.uri.scheme === 'file' && !seen.has(key);
    if (concerns && isDamaged(document.getText())) {
      seen.add(key);
      void restore(document);
    }
  };
  vscode.workspace.textDocuments.forEach(look);
  return vscode.Disposable.from(
    vscode.workspace.onDidOpenTextDocument(look),
    vscode.workspace.onDidCloseTextDocument((document) => {
      // A document that only changes its language is closed and opened again.
      if (document.isClosed) {
        seen.delete(document.uri.toString());
      }
    }),
  );
}

async function restore(document: vscode.TextDocument): Promise<void> {
  const scope = { uri: document.uri, languageId: document.languageId };
  const configured = vscode.workspace.getConfiguration('files', scope).get<string>('encoding');
  const encoding = again(configured, document.encoding) ?? (await ask(document));
  if (encoding === undefined) {
    return;
  }
  try {
    await vscode.workspace.openTextDocument(document.uri, { encoding });
  } catch (error) {
    // A program with unsaved changes cannot be read again.
    void vscode.window.showErrorMessage(error instanceof Error ? error.message : String(error));
  }
}

async function ask(document: vscode.TextDocument): Promise<string | undefined> {
  const others = CODE_PAGES.filter((page) => page.id !== document.encoding);
  const chosen = await vscode.window.showWarningMessage(
    vscode.l10n.t(
      '{0} was read as {1}, but is in another code page. Saving it now would destroy letters in its comments. Read it again as:',
      vscode.workspace.asRelativePath(document.uri),
      document.encoding,
    ),
    ...others.map((page) => page.label),
  );
  return others.find(({ label }) => label === chosen)?.id;
}

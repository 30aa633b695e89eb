// A program that was read in a wrong code page must not be saved in it.

import * as vscode from 'vscode';

import { CODE_PAGES, isDamaged } from './encoding';
import { type Editor, Rescue } from './rescue';

/**
 * Looks at each program when it is opened, and before it is saved. One that the editor took for UTF-8, because its name did
 * not say that it is a program or because the editor was still starting, is read again as the settings say; else the user is
 * asked. What was typed before that is kept. Saved meanwhile, it gets its letters from the file on disk.
 */
export function guardEncodings(): vscode.Disposable {
  const rescue = new Rescue(EDITOR);
  const seen = new Set<string>();
  const concerns = (document: vscode.TextDocument) =>
    document.languageId === 'cnc872' && document.uri.scheme === 'file' && isDamaged(document.getText());
  const look = (document: vscode.TextDocument) => {
    const key = document.uri.toString();
    if (!seen.has(key) && concerns(document)) {
      seen.add(key);
      rescue.restore(document).catch(report);
    }
  };
  vscode.workspace.textDocuments.forEach(look);
  return vscode.Disposable.from(
    vscode.workspace.onDidOpenTextDocument(look),
    vscode.workspace.onWillSaveTextDocument((event) => {
      const { document } = event;
      if (concerns(document)) {
        event.waitUntil(rescue.beforeSave(document).then((text) => (text === undefined ? [] : [edit(document, text)])));
      }
    }),
    vscode.workspace.onDidSaveTextDocument((document) => {
      rescue.afterSave(document).catch(report);
    }),
    vscode.workspace.onDidCloseTextDocument((document) => {
      // A document that only changes its language is closed and opened again.
      if (document.isClosed) {
        seen.delete(document.uri.toString());
      }
    }),
  );
}

const EDITOR: Editor<vscode.TextDocument> = {
  async read({ uri }) {
    return vscode.workspace.fs.readFile(uri).then(
      (bytes) => bytes,
      () => undefined,
    );
  },
  async write({ uri }, bytes) {
    await vscode.workspace.fs.writeFile(uri, bytes);
  },
  async decode(bytes, encoding) {
    return vscode.workspace.decode(bytes, { encoding });
  },
  async encode(text, encoding) {
    return vscode.workspace.encode(text, { encoding });
  },
  configured({ uri, languageId }) {
    return vscode.workspace.getConfiguration('files', { uri, languageId }).get<string>('encoding');
  },
  ask,
  async revert(document) {
    // The command is about the active editor.
    await vscode.window.showTextDocument(document, vscode.window.activeTextEditor?.viewColumn);
    await vscode.commands.executeCommand('workbench.action.files.revert');
  },
  async reopen({ uri }, encoding) {
    await vscode.workspace.openTextDocument(uri, { encoding });
  },
  async replace(document, text) {
    const editors = vscode.window.visibleTextEditors.filter((editor) => editor.document === document);
    const selections = editors.map((editor) => [editor, editor.selections] as const);
    const change = new vscode.WorkspaceEdit();
    change.set(document.uri, [edit(document, text)]);
    if (!(await vscode.workspace.applyEdit(change))) {
      throw new Error(vscode.l10n.t('What was typed into {0} could not be kept', document.fileName));
    }
    for (const [editor, before] of selections) {
      editor.selections = before;
    }
  },
};

/** The change that makes a document this text: what is between what both begin and end with. */
function edit(document: vscode.TextDocument, text: string): vscode.TextEdit {
  const before = document.getText();
  const most = Math.min(before.length, text.length);
  let start = 0;
  while (start < most && before[start] === text[start]) {
    start += 1;
  }
  let end = 0;
  while (end < most - start && before.at(-1 - end) === text.at(-1 - end)) {
    end += 1;
  }
  const range = new vscode.Range(document.positionAt(start), document.positionAt(before.length - end));
  return vscode.TextEdit.replace(range, text.slice(start, text.length - end));
}

function report(error: unknown): void {
  void vscode.window.showErrorMessage(error instanceof Error ? error.message : String(error));
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

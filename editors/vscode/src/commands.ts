// The commands of the palette, and those that code lenses use.

import * as vscode from 'vscode';

import { type Server, SHOW_REFERENCES } from './client';
import { continues, toggle } from './comments';
import { compareWithFile, compareWithSaved } from './compare';
import { asCode, choices, codeOf, pageOf } from './findings';
import type { PathPanel } from './panel';
import { Here } from './place';
import { language } from './settings';
import type { Views } from './view';

/** Registers every command of package.json, and that of code lenses. */
export function registerCommands(
  context: vscode.ExtensionContext,
  server: Server,
  views: Views,
  path: PathPanel,
): void {
  const here = new Here(server, views);
  const commands: Record<string, (...values: unknown[]) => unknown> = {
    'cnc872c.restart': () => server.restart(),
    'cnc872c.showOutput': () => server.output.show(),
    'cnc872c.showPath': () => {
      const program = activeProgram();
      return program && path.show(program);
    },
    'cnc872c.showStream': () => {
      const program = activeProgram();
      return program && views.showStream(program.document.uri);
    },
    'cnc872c.showSignals': () => {
      const program = activeProgram();
      return program && views.showSignals(program.document.uri, program.selection.active);
    },
    'cnc872c.stateHere': (...values) => {
      const at = asPlace(server, values) ?? cursor();
      return at && here.state(at.uri, at.position);
    },
    'cnc872c.startHere': () => {
      const at = cursor();
      return at && here.start(at.uri, at.position);
    },
    'cnc872c.explain': (code) => explain(typeof code === 'string' ? code : undefined),
    'cnc872c.compareWithSaved': () => {
      const program = activeProgram();
      return program && compareWithSaved(server, program.document);
    },
    'cnc872c.compareWithFile': () => {
      const program = activeProgram();
      return program && compareWithFile(server, program.document);
    },
    'cnc872c.fixAll': () => apply('source.fixAll.cnc872c'),
    'cnc872c.renumber': () => apply('source.renumber.cnc872c'),
    'cnc872c.toggleComment': toggleComment,
    [SHOW_REFERENCES]: (...values) => showReferences(server, values),
  };
  for (const [name, run] of Object.entries(commands)) {
    context.subscriptions.push(vscode.commands.registerCommand(name, run));
  }
}

function activeProgram(): vscode.TextEditor | undefined {
  const editor = vscode.window.activeTextEditor;
  if (editor?.document.languageId === 'cnc872') {
    return editor;
  }
  void vscode.window.showInformationMessage(vscode.l10n.t('No part program is open'));
  return undefined;
}

/** The place of the cursor. */
function cursor(): { uri: vscode.Uri; position: vscode.Position } | undefined {
  const program = activeProgram();
  return program && { uri: program.document.uri, position: program.selection.active };
}

/** `[uri, position]` as a code lens has them; undefined for what a menu hands over. */
function asPlace(
  server: Server,
  [uri, position]: unknown[],
): { uri: vscode.Uri; position: vscode.Position } | undefined {
  const convert = server.client?.protocol2CodeConverter;
  if (convert === undefined || typeof uri !== 'string') {
    return undefined;
  }
  const at = convert.asPosition(position as Parameters<typeof convert.asPosition>[0]);
  return at && { uri: convert.asUri(uri), position: at };
}

/** Lets the editor ask the server for the source action of that kind, and applies it. */
async function apply(kind: string): Promise<void> {
  if (activeProgram() !== undefined) {
    await vscode.commands.executeCommand('editor.action.sourceAction', { kind, apply: 'first' });
  }
}

/** Switches the blocks of the selected lines off or on; undone in one step. */
async function toggleComment(): Promise<void> {
  const editor = activeProgram();
  if (editor === undefined) {
    return;
  }
  const { document } = editor;
  const text = (line: number) => (line < document.lineCount ? document.lineAt(line).text : '');
  const chosen = new Set<number>();
  for (const { start, end } of editor.selections) {
    // A selection that ends before the first character of a line does not include it.
    let last = end.character === 0 && end.line > start.line ? end.line - 1 : end.line;
    let first = start.line;
    // All comments that were one line go together.
    while (first > 0 && continues(text(first))) {
      first -= 1;
    }
    while (continues(text(last + 1))) {
      last += 1;
    }
    for (let line = first; line <= last; line += 1) {
      chosen.add(line);
    }
  }
  const numbers = [...chosen].sort((a, b) => a - b);
  const toggled = toggle(numbers.map(text), numbers);
  await editor.edit((edit) => {
    numbers.forEach((line, at) => {
      const { range } = document.lineAt(line);
      const changed = toggled[at];
      if (changed === undefined) {
        edit.delete(new vscode.Range(document.lineAt(line - 1).range.end, range.end));
      } else {
        edit.replace(range, changed);
      }
    });
  });
}

/** `[uri, position, locations]` as LSP writes them. */
async function showReferences(server: Server, [uri, position, locations]: unknown[]): Promise<void> {
  const convert = server.client?.protocol2CodeConverter;
  if (convert === undefined || typeof uri !== 'string' || !Array.isArray(locations)) {
    return;
  }
  await vscode.commands.executeCommand(
    'editor.action.showReferences',
    convert.asUri(uri),
    convert.asPosition(position as Parameters<typeof convert.asPosition>[0]),
    locations.map((location) => convert.asLocation(location as Parameters<typeof convert.asLocation>[0])),
  );
}

interface Entry extends vscode.QuickPickItem {
  readonly code?: string;
}

async function explain(given: string | undefined): Promise<void> {
  const editor = vscode.window.activeTextEditor;
  const findings = editor === undefined ? [] : vscode.languages.getDiagnostics(editor.document.uri);
  const code = given === undefined ? await choose(editor, findings) : asCode(given);
  if (code === undefined) {
    return;
  }
  const target = findings.find((finding) => codeOf(finding) === code)?.code;
  const setting = vscode.workspace.getConfiguration('cnc872c').get('language');
  const page =
    typeof target === 'object' && target.target.scheme === 'cnc872c'
      ? target.target
      : vscode.Uri.parse(pageOf(code, language(setting, vscode.env.language)));
  try {
    // The page is asked for first: the preview would show its absence as an empty page.
    await vscode.workspace.openTextDocument(page);
  } catch {
    void vscode.window.showWarningMessage(vscode.l10n.t('There is no page about {0}', code));
    return;
  }
  await vscode.commands.executeCommand('markdown.showPreviewToSide', page);
}

/** The code of a finding of this program, or one that is typed. */
async function choose(
  editor: vscode.TextEditor | undefined,
  findings: readonly vscode.Diagnostic[],
): Promise<string | undefined> {
  const known = choices(findings, editor?.selection.active ?? new vscode.Position(0, 0));
  const here = known.filter((choice) => choice.here);
  const only = here[0];
  if (here.length === 1 && only !== undefined) {
    return only.code;
  }
  if (known.length > 0) {
    const other: Entry = { label: vscode.l10n.t('Another code…') };
    const entries: Entry[] = known.map(({ code, message }) => ({ label: code, description: message, code }));
    const placeHolder = vscode.l10n.t('Which finding?');
    const chosen = await vscode.window.showQuickPick([...entries, other], { placeHolder, matchOnDescription: true });
    if (chosen !== other) {
      return chosen?.code;
    }
  }
  const typed = await vscode.window.showInputBox({
    prompt: vscode.l10n.t('Code of a finding'),
    placeHolder: 'E0306',
    validateInput: (text) =>
      text === '' || asCode(text) !== undefined ? undefined : vscode.l10n.t('A code is E or W and four digits'),
  });
  return typed === undefined ? undefined : asCode(typed);
}

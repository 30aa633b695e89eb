// "State here" and "start here": questions about the place of the cursor, with the choice between several executions.

import * as vscode from 'vscode';

import type { Server } from './client';
import { type Pass, type PlaceAnswer, asPlaceAnswer, statePath } from './answer';
import type { Views } from './view';

/** What the user has chosen so far. */
interface Choice {
  /** Which executed block. */
  readonly seq?: number;
  /** The height at which the tool is clear of everything. */
  readonly safe?: string;
}

/** Asks the server about places, and shows what it answers. */
export class Here {
  constructor(
    private readonly server: Server,
    private readonly views: Views,
  ) {}

  /** Shows what holds before the block at a place. */
  async state(program: vscode.Uri, place: vscode.Position): Promise<void> {
    const title = vscode.l10n.t('Looking at the state at the block');
    const answer = await this.ask('cnc872c/state', program, place, title, {});
    if (answer?.kind === 'text') {
      await this.views.showText(statePath(program.path), program, answer.text);
    }
  }

  /** Opens a program that starts at a place beside the program. */
  async start(program: vscode.Uri, place: vscode.Position): Promise<void> {
    const title = vscode.l10n.t('Making a program that starts at the block');
    const answer = await this.ask('cnc872c/restart', program, place, title, {});
    if (answer?.kind !== 'text') {
      return;
    }
    const document = await vscode.workspace.openTextDocument({ language: 'cnc872', content: answer.text });
    await vscode.window.showTextDocument(document, { viewColumn: vscode.ViewColumn.Beside });
    const read = vscode.l10n.t('Read the comments at the top before starting; the program is not saved yet.');
    void vscode.window.showInformationMessage([answer.message, read].filter((text) => text !== undefined).join(' — '));
  }

  /** The answer that is a text; undefined when there is none, which the user has seen, or wants none any more. */
  private async ask(
    method: string,
    program: vscode.Uri,
    place: vscode.Position,
    title: string,
    choice: Choice,
  ): Promise<PlaceAnswer | undefined> {
    const again = (more: Choice) => this.ask(method, program, place, title, { ...choice, ...more });
    const answer = await this.request(method, program, place, title, choice);
    switch (answer?.kind) {
      case undefined:
      case 'text':
        return answer;
      case 'nothing':
        void vscode.window.showInformationMessage(vscode.l10n.t('There is no block here'));
        return undefined;
      case 'passes': {
        const seq = await choose(answer.message, answer.passes, answer.count);
        return seq === undefined ? undefined : again({ seq });
      }
      case 'safe': {
        const safe = await vscode.window.showInputBox({
          title: answer.message,
          prompt: vscode.l10n.t('Height in mm at which the tool is clear of everything, as programmed'),
          placeHolder: '100',
        });
        return safe === undefined || safe.trim() === '' ? undefined : again({ safe });
      }
      case 'refused': {
        const { nearest } = answer;
        const there = nearest && vscode.l10n.t('Start at N{0} (seq {1})', nearest.n, nearest.seq);
        const items = there === undefined ? [] : [there];
        const chosen = await vscode.window.showWarningMessage(answer.message, { modal: true }, ...items);
        return nearest !== undefined && chosen === there ? again({ seq: nearest.seq }) : undefined;
      }
    }
  }

  private async request(
    method: string,
    program: vscode.Uri,
    place: vscode.Position,
    title: string,
    choice: Choice,
  ): Promise<PlaceAnswer | undefined> {
    const client = this.server.client;
    if (client === undefined) {
      void vscode.window.showWarningMessage(vscode.l10n.t('The language server is not running'));
      return undefined;
    }
    const request = {
      textDocument: { uri: program.toString() },
      position: { line: place.line, character: place.character },
      ...choice,
    };
    return vscode.window.withProgress({ location: vscode.ProgressLocation.Window, title }, () =>
      client.sendRequest(method, request).then(asPlaceAnswer, (error: unknown) => {
        void vscode.window.showErrorMessage(error instanceof Error ? error.message : String(error));
        return undefined;
      }),
    );
  }
}

/** Lets the user choose one execution of a block. */
async function choose(placeHolder: string, passes: readonly Pass[], count: number): Promise<number | undefined> {
  const items = passes.map((pass) => ({
    label: vscode.l10n.t('Pass {0}', pass.pass),
    description: pass.text,
    seq: pass.seq,
  }));
  const more = count - passes.length;
  const title = more > 0 ? { title: vscode.l10n.t('{0} more: cnc872c state FILE --n N --pass PASS', more) } : {};
  const chosen = await vscode.window.showQuickPick(items, { placeHolder, ...title, matchOnDescription: true });
  return chosen?.seq;
}

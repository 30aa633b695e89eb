// The extension as VS Code calls it: what starts, stops and is registered.

import type * as vscode from 'vscode';

import { Server } from './client';
import { registerCommands } from './commands';
import { Dots } from './dots';
import { guardEncodings } from './guard';
import { PathPanel } from './panel';
import { Views } from './view';

let server: Server | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  // Before all else: somebody may be typing already. It needs no server.
  context.subscriptions.push(guardEncodings());
  const started = new Server(context);
  server = started;
  const views = new Views(started);
  const path = new PathPanel(started, context.extensionUri);
  context.subscriptions.push(started, views, path, new Dots(started));
  registerCommands(context, started, views, path);
  await started.start();
}

export async function deactivate(): Promise<void> {
  await server?.stop();
}

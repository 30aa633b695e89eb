// The extension as VS Code calls it: what starts, stops and is registered.

import * as vscode from 'vscode';

import { Server } from './client';
import { registerCommands } from './commands';
import { Dots } from './dots';
import { guardEncodings } from './guard';
import { Views } from './view';

let server: Server | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const started = new Server(context);
  server = started;
  const views = new Views(started);
  context.subscriptions.push(started, views, new Dots(started), guardEncodings());
  registerCommands(context, started, views);
  await started.start();
}

export async function deactivate(): Promise<void> {
  await server?.stop();
}

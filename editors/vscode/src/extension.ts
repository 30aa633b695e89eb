// The extension as VS Code calls it: what starts, stops and is registered.

import * as vscode from 'vscode';

import { Server } from './client';
import { registerCommands } from './commands';
import { guardEncodings } from './guard';
import { StreamView } from './view';

let server: Server | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const started = new Server(context);
  server = started;
  const streams = new StreamView(started);
  context.subscriptions.push(started, streams, guardEncodings());
  registerCommands(context, started, streams);
  await started.start();
}

export async function deactivate(): Promise<void> {
  await server?.stop();
}

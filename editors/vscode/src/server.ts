// Where the language server is. No VS Code here: what is known of the machine comes as arguments.

import * as path from 'node:path';

/** What the search needs to know of the machine. */
export interface Machine {
  readonly platform: NodeJS.Platform;
  /** The environment; on Windows its names are found whatever their case. */
  readonly env: Readonly<Record<string, string | undefined>>;
  readonly home: string;
  /** Whether a path is a file that can be run. */
  readonly isProgram: (file: string) => boolean;
}

/** What the user and the extension say about the place of the server. */
export interface Wishes {
  /** The setting `cnc872c.server.path`; empty or missing is unset. */
  readonly setting: string | null | undefined;
  /** Folder of the extension; a server in `server/` of it comes with it. */
  readonly extension: string;
  /** First folder of the workspace: `${workspaceFolder}` in the setting. */
  readonly workspace: string | undefined;
}

export type Found =
  | { readonly kind: 'found'; readonly program: string }
  /** The setting names a program that is not there. */
  | { readonly kind: 'wrong-setting'; readonly program: string }
  /** Neither with the extension nor on PATH. */
  | { readonly kind: 'missing' };

/** The server to run: by the setting, else the one that came with the extension, else `cnc872c` on PATH. */
export function findServer(wishes: Wishes, machine: Machine): Found {
  const paths = machine.platform === 'win32' ? path.win32 : path.posix;
  const setting = wishes.setting?.trim();
  if (setting) {
    const expanded = expand(setting, wishes.workspace, machine);
    if (isBareName(expanded)) {
      const program = onPath(expanded, machine);
      return program === undefined ? { kind: 'wrong-setting', program: expanded } : { kind: 'found', program };
    }
    const absolute = paths.resolve(wishes.workspace ?? machine.home, expanded);
    const program = withExtension(absolute, machine);
    return program === undefined ? { kind: 'wrong-setting', program: absolute } : { kind: 'found', program };
  }
  const bundled = withExtension(paths.join(wishes.extension, 'server', 'cnc872c'), machine);
  const program = bundled ?? onPath('cnc872c', machine);
  return program === undefined ? { kind: 'missing' } : { kind: 'found', program };
}

function expand(setting: string, workspace: string | undefined, machine: Machine): string {
  const home = setting.replace(/^~(?=$|[/\\])/, () => machine.home);
  return workspace === undefined ? home : home.replaceAll('${workspaceFolder}', () => workspace);
}

function isBareName(name: string): boolean {
  return !/[/\\]/.test(name);
}

/**
 * The program of that name on PATH. Relative folders on PATH and the current folder are left out: what lies in an opened
 * folder is not run because of its name.
 */
function onPath(name: string, machine: Machine): string | undefined {
  const windows = machine.platform === 'win32';
  const paths = windows ? path.win32 : path.posix;
  for (const folder of (variable('PATH', machine) ?? '').split(windows ? ';' : ':')) {
    const bare = windows ? folder.replace(/^"(.*)"$/, '$1') : folder;
    if (paths.isAbsolute(bare)) {
      const program = withExtension(paths.join(bare, name), machine);
      if (program !== undefined) {
        return program;
      }
    }
  }
  return undefined;
}

function withExtension(file: string, machine: Machine): string | undefined {
  const endings = machine.platform === 'win32' && !/\.exe$/i.test(file) ? ['.exe'] : [''];
  return endings.map((ending) => file + ending).find((candidate) => machine.isProgram(candidate));
}

function variable(name: string, machine: Machine): string | undefined {
  if (machine.platform !== 'win32') {
    return machine.env[name];
  }
  const found = Object.keys(machine.env).find((key) => key.toUpperCase() === name);
  return found === undefined ? undefined : machine.env[found];
}

// The viewer in a panel beside the text of an editor: the editor gives the data and says where its cursor is, the viewer says
// which block is in hand. `editors/vscode/src/path.ts` is the other side.

import type { App } from './app.ts';

/** A block as the text has it: index of the file, line from 1. */
export interface Place {
  file: number;
  line: number;
}

/** What the editor says. */
type Message =
  | { cnc872c: 'data'; data: Uint8Array<ArrayBuffer>; place?: Place }
  | { cnc872c: 'cursor'; place: Place }
  /** The program cannot be executed now: the picture is that of an earlier text. */
  | { cnc872c: 'stale' };

interface Host {
  postMessage(message: unknown): void;
}

declare const acquireVsCodeApi: (() => Host) | undefined;

/** Milliseconds between two places that the editor hears of while the path is played. */
const PLAYED = 150;

/** The editor around the page, if there is one. */
export function editor(): Editor | undefined {
  return typeof acquireVsCodeApi === 'function' ? new Editor(acquireVsCodeApi()) : undefined;
}

export class Editor {
  readonly #host: Host;
  readonly #first: Promise<{ data: Uint8Array<ArrayBuffer>; place: Place | undefined }>;
  #app: App | undefined;
  #last = Promise.resolve();
  #read: ((data: Uint8Array<ArrayBuffer>, place: Place | undefined) => Promise<void>) | undefined;

  constructor(host: Host) {
    this.#host = host;
    document.body.classList.add('in-editor');
    this.#first = new Promise((resolve) => {
      window.addEventListener('message', (event: MessageEvent<Message>) => {
        const message = event.data;
        if (message.cnc872c === 'data') {
          resolve({ data: message.data, place: message.place });
          // One after the other: the last text stays.
          this.#last = this.#last.then(() => this.#read?.(message.data, message.place));
        } else if (message.cnc872c === 'cursor') {
          this.#app?.follow(message.place);
        } else if (message.cnc872c === 'stale') {
          this.#app?.age();
        }
      });
    });
    host.postMessage({ cnc872c: 'ready' });
  }

  /** The first data. */
  first(): Promise<{ data: Uint8Array<ArrayBuffer>; place: Place | undefined }> {
    return this.#first;
  }

  /** From now on cursor and block in hand are one, and `read` takes up later data. */
  connect(app: App, read: (data: Uint8Array<ArrayBuffer>, place: Place | undefined) => Promise<void>): void {
    this.#app = app;
    this.#read = read;
    let timer = 0;
    app.on('select', ({ index, by }) => {
      window.clearTimeout(timer);
      if (index === null || by === 'script') {
        return;
      }
      const tell = (): void => {
        if (app.current !== null) {
          const { seq, file, line } = app.place(app.current);
          this.#host.postMessage({ cnc872c: 'select', detail: { seq, file, line } });
        }
      };
      if (by === 'play') {
        timer = window.setTimeout(tell, PLAYED);
      } else {
        tell();
      }
    });
  }
}

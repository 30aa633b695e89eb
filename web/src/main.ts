// The page: reads its data, builds itself, draws the path.

import './styles.css';

import { api, connect, type Api } from './api.ts';
import { App } from './app.ts';
import { bytesOfText, Container, inflate } from './data/columns.ts';
import type { Header } from './data/header.ts';
import { type Key, type Lang, language, setLanguage, t } from './i18n.ts';
import { editor } from './panel.ts';
import { View } from './scene/view.ts';
import { followTheme } from './theme.ts';
import { changes } from './ui/changes.ts';
import { Chart } from './ui/chart.ts';
import { Code } from './ui/code.ts';
import { h, labelled, retell } from './ui/dom.ts';
import { divider } from './ui/divider.ts';
import { filter } from './ui/filter.ts';
import { Help } from './ui/help.ts';
import { hover } from './ui/hover.ts';
import { findings, joints } from './ui/lists.ts';
import { measure } from './ui/measure.ts';
import { Player } from './ui/player.ts';
import { State } from './ui/state.ts';
import { tabs } from './ui/tabs.ts';
import { legend, title, toolbar } from './ui/toolbar.ts';

/** The form of the data that is read here. */
const SCHEMA = 'cnc872c.path/1';

declare global {
  interface Window {
    cnc872c: Api;
  }
}

/** The language of the page: the one it was made for, else the browser's. */
function chooseLanguage(): Lang {
  const made = document.documentElement.dataset['lang'];
  if (made === 'en' || made === 'cs') {
    return made;
  }
  const wanted = navigator.languages.map((tag) => tag.toLowerCase().split('-')[0]);
  return wanted.find((tag): tag is Lang => tag === 'en' || tag === 'cs') ?? 'en';
}

/** The data that the page holds; of the old program too, on a page of `compare`. */
function ownData(id: 'cnc872c-data' | 'cnc872c-old'): Uint8Array<ArrayBuffer> | undefined {
  const holder = document.getElementById(id);
  if (holder === null) {
    return undefined;
  }
  const bytes = bytesOfText(holder.textContent ?? '');
  // The text is not needed any more: it would take memory.
  holder.remove();
  return bytes;
}

async function unpack(bytes: Uint8Array<ArrayBuffer>): Promise<Container<Header>> {
  const data = new Container<Header>(await inflate(bytes));
  if (data.header.schema !== SCHEMA) {
    throw new Error(`${data.header.schema}, ${SCHEMA}`);
  }
  return data;
}

function build(app: App): { view: View; player: Player; say: (lang: Lang) => void } {
  const stage = h('div', { class: 'stage' });
  const help = new Help();
  const root = h('div', { class: 'page' });
  const say = (lang: Lang): void => {
    setLanguage(lang);
    document.documentElement.lang = lang;
    retell(root);
    view.describe();
    app.emit('language', undefined);
  };
  root.append(h('header', { class: 'top' }, title(app)));
  const main = h('main', {}, labelled(h('section', { class: 'picture' }, stage), 'path'));
  root.append(main);
  document.body.append(root, help.element);
  const view = new View(app, stage);
  root.querySelector('header')!.append(toolbar(app, view, say, () => help.open()));
  stage.before(legend(app, view));
  const player = new Player(app, view);
  const side = labelled(h('aside', {}), 'details');
  const details = tabs(
    'details',
    [
      ...(app.comparison === undefined ? [] : [['changes', changes(app, app.comparison, view)] as [Key, HTMLElement]]),
      ['block', new State(app).element],
      ['joints', joints(app, view)],
      ['findings', findings(app, view)],
      ['measure', measure(app, view)],
      ['filter', filter(app)],
    ],
    (key) =>
      key === 'findings' ? app.header.findings.length : key === 'changes' ? app.comparison!.compared.changes.length : 0,
  );
  app.on('data', details.tell);
  app.on('language', details.tell);
  const opens = (): void => {
    if (app.header.findings.some((finding) => finding.severity === 'error')) {
      details.show('findings');
    }
  };
  opens();
  side.append(new Code(app).element, details.element);
  main.append(divider(main), side);
  root.append(h('footer', {}, player.element, new Chart(app, view).element));
  hover(app, view, stage);
  view.canvas.addEventListener('keydown', (event) => {
    const actions: { [key: string]: () => void } = {
      ',': () => app.step(-1),
      '.': () => app.step(1),
      '[': () => app.stepPass(-1),
      ']': () => app.stepPass(1),
      ' ': () => player.toggle(),
      '?': () => help.open(),
    };
    const action = event.ctrlKey || event.altKey || event.metaKey ? undefined : actions[event.key];
    if (action !== undefined) {
      event.preventDefault();
      action();
    }
  });
  say(language());
  return { view, player, say };
}

/** While there is nothing else to do, what the first block in hand would wait for. Not every browser says when that is. */
function prepare(app: App): void {
  if ('requestIdleCallback' in window) {
    window.requestIdleCallback(() => app.program.prepare());
  }
}

async function start(): Promise<void> {
  setLanguage(chooseLanguage());
  document.documentElement.lang = language();
  let drawn!: () => void;
  let failed!: (error: unknown) => void;
  const ready = new Promise<void>((resolve, reject) => {
    drawn = resolve;
    failed = reject;
  });
  // Whoever asks before the data are read waits for `ready`.
  window.cnc872c = { ready } as Api;
  ready.catch(() => undefined);
  let shown: App | undefined;
  followTheme(() => shown?.emit('theme', undefined));
  try {
    // A page that holds its data needs no editor, also in one.
    const around = document.getElementById('cnc872c-data') === null ? editor() : undefined;
    const { data, place } =
      around === undefined ? { data: ownData('cnc872c-data')!, place: undefined } : await around.first();
    const old = ownData('cnc872c-old');
    const app = new App(await unpack(data), old && (await unpack(old)));
    shown = app;
    const { view, player, say } = build(app);
    view.drawNow();
    window.cnc872c = api(app, view, player, say, ready);
    connect(app, window.cnc872c);
    around?.connect(app, async (later, at) => app.replace(await unpack(later), at));
    if (place !== undefined) {
      app.follow(place);
    }
    prepare(app);
    app.on('data', () => prepare(app));
    drawn();
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    document.body.append(h('p', { class: 'failure', role: 'alert' }, t('cannotRead', { reason })));
    failed(error);
    throw error;
  }
}

void start();

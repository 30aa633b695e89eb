// What the server answers to questions about a place. No VS Code here.

/** One execution of a block. */
export interface Pass {
  /** From 1. */
  readonly pass: number;
  /** Which executed block. */
  readonly seq: number;
  readonly text: string;
}

/** What the server's requests `cnc872c/state` and `cnc872c/restart` answer. */
export type PlaceAnswer =
  | { readonly kind: 'text'; readonly text: string; readonly message: string | undefined }
  /** Several executions, one of which is to be chosen. */
  | { readonly kind: 'passes'; readonly message: string; readonly count: number; readonly passes: readonly Pass[] }
  /** The height at which the tool is clear of everything is missing. */
  | { readonly kind: 'safe'; readonly message: string }
  | { readonly kind: 'refused'; readonly message: string; readonly nearest: Nearest | undefined }
  /** No block is there. */
  | { readonly kind: 'nothing' };

/** The nearest earlier place where a start is possible. */
export interface Nearest {
  readonly seq: number;
  readonly n: number;
}

/** The answer; undefined when it has another form. */
export function asPlaceAnswer(answer: unknown): PlaceAnswer | undefined {
  if (answer === null) {
    return { kind: 'nothing' };
  }
  if (typeof answer !== 'object') {
    return undefined;
  }
  const { text, message, count, passes, safe, refused, nearest } = answer as Record<string, unknown>;
  if (typeof text === 'string') {
    return { kind: 'text', text, message: typeof message === 'string' ? message : undefined };
  }
  if (Array.isArray(passes) && typeof message === 'string' && typeof count === 'number') {
    return { kind: 'passes', message, count, passes: passes.filter(isPass) };
  }
  if (typeof safe === 'string') {
    return { kind: 'safe', message: safe };
  }
  if (typeof refused === 'string') {
    return { kind: 'refused', message: refused, nearest: isNearest(nearest) ? nearest : undefined };
  }
  return undefined;
}

function isPass(value: unknown): value is Pass {
  const { pass, seq, text } = (value ?? {}) as Record<string, unknown>;
  return typeof pass === 'number' && typeof seq === 'number' && typeof text === 'string';
}

function isNearest(value: unknown): value is Nearest {
  const { seq, n } = (value ?? {}) as Record<string, unknown>;
  return typeof seq === 'number' && typeof n === 'number';
}

/** Path of the view of the state at a place of a program: what stands in its tab. */
export function statePath(program: string): string {
  return `/${program.split(/[/\\]/).pop() || 'program'}.state.txt`;
}

// The read-only view of a block stream: its name, and what the server answers. No VS Code here.

/** What the server's command `cnc872c.stream` answers. */
export interface Stream {
  readonly text: string;
  /** Whether there is more than the text shows. */
  readonly truncated: boolean;
}

/** The answer if it has the right form. */
export function asStream(answer: unknown): Stream | undefined {
  if (typeof answer !== 'object' || answer === null) {
    return undefined;
  }
  const { text, truncated } = answer as Partial<Record<keyof Stream, unknown>>;
  return typeof text === 'string' ? { text, truncated: truncated === true } : undefined;
}

/** How many block records a stream has. */
export function blocks(text: string): number {
  let count = 0;
  for (const line of text.split('\n')) {
    if (/^\{"kind": ?"block"/.test(line)) {
      count += 1;
    }
  }
  return count;
}

/** Path of the view of a program's stream: what stands in its tab. */
export function viewPath(program: string): string {
  const name = program.split(/[/\\]/).pop() || 'program';
  return `/${name}.jsonl`;
}

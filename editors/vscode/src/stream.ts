// The read-only views: their names, and what the server answers. No VS Code here.

/** What the server's command `cnc872c.stream` and its request `cnc872c/signals` answer. */
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

/** A dot that the control draws at a joint of motions. */
export interface Dot {
  /** From 0. */
  readonly line: number;
  readonly dot: 'yellow' | 'red';
}

/** The dots that the server's request `cnc872c/dots` answers; none when the answer has another form. */
export function asDots(answer: unknown): readonly Dot[] {
  const dots: readonly unknown[] = Array.isArray(answer) ? answer : [];
  return dots.filter((dot): dot is Dot => {
    const { line, dot: kind } = (dot ?? {}) as Partial<Record<keyof Dot, unknown>>;
    return typeof line === 'number' && (kind === 'yellow' || kind === 'red');
  });
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
  return `/${fileName(program)}.jsonl`;
}

/** Path of the view of the PLC signals of a block. */
export function signalsPath(program: string): string {
  return `/${fileName(program)}.plc.txt`;
}

function fileName(program: string): string {
  return program.split(/[/\\]/).pop() || 'program';
}

// Blocks turned into comments and back, line by line. No VS Code here.
//
// A comment of the language runs from one quote to the next and never crosses a line end, so no pair of quotes around a
// selection can switch it off. Each line becomes a comment of its own, `"// …"`: the quotes in it become apostrophes, and
// come back when the line is switched on again.

const SWITCHED_OFF = /^(\s*)"\/\/ (.*)"(\s*)$/;

/** Whether the line is one that `switchOff` made. */
export function isOff(line: string): boolean {
  const [, , inside] = SWITCHED_OFF.exec(line) ?? [];
  return inside !== undefined && !inside.includes('"');
}

/** The line as a comment. */
export function switchOff(line: string): string {
  const [, indent = '', text = '', end = ''] = /^(\s*)(.*?)(\s*)$/.exec(line) ?? [];
  const inside = text.replace(/[\^'"]/g, (character) => (character === '"' ? "'" : `^${character}`));
  return `${indent}"// ${inside}"${end}`;
}

/** The line that `switchOff` made a comment. */
export function switchOn(line: string): string {
  const [, indent = '', inside = '', end = ''] = SWITCHED_OFF.exec(line) ?? [];
  const text = inside.replace(/\^([\^'])|'/g, (_, kept: string | undefined) => kept ?? '"');
  return `${indent}${text}${end}`;
}

/** The lines switched off, or on again when all of them are off; empty ones stay. */
export function toggle(lines: readonly string[]): string[] {
  const written = lines.filter((line) => line.trim() !== '');
  const change = written.length > 0 && written.every(isOff) ? switchOn : switchOff;
  return lines.map((line) => (line.trim() === '' ? line : change(line)));
}

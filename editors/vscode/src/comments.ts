// Blocks turned into comments and back, line by line. No VS Code here.
//
// A comment of the language runs from one quote to the next and never crosses a line end, so no pair of quotes around a
// selection can switch it off. Each line becomes a comment, `"// …"`: the quotes in it become apostrophes, and come back
// when the line is switched on again. A line has at most 80 characters (LEX-7): what does not fit follows in lines of
// `"//+ …"`.

const LINE = 80;
const SWITCHED_OFF = /^(\s*)"\/\/(\+?) (.*)"(\s*)$/;

/** Whether the line is one that `switchOff` made. */
export function isOff(line: string): boolean {
  const [, , , inside] = SWITCHED_OFF.exec(line) ?? [];
  return inside !== undefined && !inside.includes('"');
}

/** Whether the line continues the one before it, which `switchOff` made too. */
export function continues(line: string): boolean {
  return isOff(line) && SWITCHED_OFF.exec(line)?.[2] === '+';
}

/** The line as comments, one below the other, none longer than a line may be. */
export function switchOff(line: string): string {
  const [, indent = '', text = '', end = ''] = /^(\s*)(.*?)(\s*)$/.exec(line) ?? [];
  const inside = text.replace(/[\^'"]/g, (character) => (character === '"' ? "'" : `^${character}`));
  const comments: string[] = [];
  let rest = inside;
  do {
    const begin = `${indent}"//${comments.length > 0 ? '+' : ''} `;
    const part = head(rest, Math.max(LINE - begin.length - 1, 2));
    rest = rest.slice(part.length);
    comments.push(`${begin}${part}"`);
  } while (rest !== '');
  // Blanks at the end of the line are kept where they make it no longer than it was.
  return comments.join('\n') + (end.length <= LINE - (comments.at(-1) ?? '').length ? end : '');
}

/** As much of a text as fits, up to behind its last blank if there is one; a pair with `^` stays together. */
function head(text: string, room: number): string {
  let length = 0;
  let blank = 0;
  for (const unit of text.match(/\^.|./gsu) ?? []) {
    if (length + unit.length > room) {
      return text.slice(0, blank > 0 ? blank : length);
    }
    length += unit.length;
    if (unit === ' ') {
      blank = length;
    }
  }
  return text;
}

/** The line that `switchOff` made a comment, or the part of it that the comment holds. */
export function switchOn(line: string): string {
  const [, indent = '', more, inside = '', end = ''] = SWITCHED_OFF.exec(line) ?? [];
  const text = inside.replace(/\^([\^'])|'/g, (_, kept: string | undefined) => kept ?? '"');
  return `${more === '+' ? '' : indent}${text}${end}`;
}

/**
 * The lines switched off, or on again when all of them are off; empty ones stay. Each line becomes one or more, or none
 * (`undefined`) where it joins the one before it. `numbers` are those of the lines in their document.
 */
export function toggle(
  lines: readonly string[],
  numbers: readonly number[] = lines.map((_, at) => at),
): (string | undefined)[] {
  const written = lines.filter((line) => line.trim() !== '');
  if (written.length === 0 || !written.every(isOff)) {
    return lines.map((line) => (line.trim() === '' ? line : switchOff(line)));
  }
  const toggled: (string | undefined)[] = [];
  let begin: number | undefined;
  lines.forEach((line, at) => {
    const before = continues(line) && numbers[at - 1] === (numbers[at] ?? 0) - 1 ? begin : undefined;
    if (before === undefined) {
      toggled.push(line.trim() === '' ? line : switchOn(line));
      begin = line.trim() === '' ? undefined : at;
    } else {
      toggled.push(undefined);
      toggled[before] = (toggled[before] ?? '') + switchOn(line);
    }
  });
  return toggled;
}

// Arguments of a command line that somebody copies into a terminal.

/** An argument as shells read it: bare, between double quotes, or, when those let something through, between single ones. */
export function quoted(argument: string): string {
  if (/^[\w./+=-]+$/.test(argument)) {
    return argument;
  }
  return /^[^"$`\\!%\p{Cc}]+$/u.test(argument) ? `"${argument}"` : `'${argument.replaceAll("'", String.raw`'\''`)}'`;
}

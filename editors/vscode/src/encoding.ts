// Whether a file was read in a code page that cannot be right. No VS Code here.

/** The code pages of the machines by their names in the editor, the likeliest first. Kamenický is unknown to it. */
export const CODE_PAGES = [
  { id: 'cp852', label: 'CP852 (DOS Latin 2)' },
  { id: 'windows1250', label: 'Windows-1250' },
  { id: 'iso88592', label: 'ISO 8859-2' },
] as const;

/**
 * Whether the text holds the character that stands for bytes that could not be read: saving it would destroy them.
 * A file that was never saved has nothing to lose.
 */
export function isDamaged(text: string): boolean {
  return text.includes('\uFFFD');
}

/** The encoding to read a damaged file again in without asking: the configured one, when it was not the one used. */
export function again(configured: string | undefined, used: string): string | undefined {
  return CODE_PAGES.some((page) => page.id === configured) && configured !== used ? configured : undefined;
}

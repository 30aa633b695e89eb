// Codes of findings and their pages. No VS Code here.

/** What of a finding of the editor is needed here. */
export interface Finding {
  readonly source?: string | undefined;
  readonly message: string;
  readonly code?: string | number | { readonly value: string | number; readonly target: unknown } | undefined;
  readonly range: { readonly start: Place; readonly end: Place };
}

interface Place {
  readonly line: number;
  readonly character: number;
}

/** A code, once, with the message of its first finding. */
export interface Choice {
  readonly code: string;
  readonly message: string;
  /** Whether the cursor stands in the finding. */
  readonly here: boolean;
}

const CODE = /^[EW]\d{4}$/;

/** The code as it is written in the project, if the text is one. */
export function asCode(text: string): string | undefined {
  const code = text.trim().toUpperCase();
  return CODE.test(code) ? code : undefined;
}

/** The code of a finding. */
export function codeOf(finding: Finding): string | undefined {
  const code = typeof finding.code === 'object' ? finding.code.value : finding.code;
  return code === undefined ? undefined : asCode(String(code));
}

/** What can be explained: the findings at the cursor, then those of its line, then the others of the file, each code once. */
export function choices(findings: readonly Finding[], cursor: Place): Choice[] {
  const ranked = findings
    .flatMap((finding) => {
      const code = codeOf(finding);
      return code === undefined ? [] : [{ finding, code, rank: rank(finding, cursor) }];
    })
    .sort((a, b) => a.rank - b.rank || order(a.finding.range.start, b.finding.range.start));
  const seen = new Map<string, Choice>();
  for (const { finding, code, rank } of ranked) {
    if (!seen.has(code)) {
      seen.set(code, { code, message: finding.message.split('\n', 1)[0] ?? '', here: rank === 0 });
    }
  }
  return [...seen.values()];
}

function rank({ range }: Finding, cursor: Place): number {
  if (order(range.start, cursor) <= 0 && order(cursor, range.end) <= 0) {
    return 0;
  }
  return range.start.line <= cursor.line && cursor.line <= range.end.line ? 1 : 2;
}

function order(a: Place, b: Place): number {
  return a.line - b.line || a.character - b.character;
}

/** The page of a code, as the server names it. */
export function pageOf(code: string, language: 'en' | 'cs'): string {
  return `cnc872c:/explain/${language}/${code}.md`;
}

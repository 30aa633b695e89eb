// What the server says of a program's path, and what the panel's page is. No VS Code here.

/** What the server's request `cnc872c/path` answers. */
export interface Path {
  /** The program that is shown. */
  readonly uri: string;
  /** Its files, by the index that the data give them. */
  readonly files: readonly (string | undefined)[];
  /** How many blocks were executed, and whether there are more. */
  readonly blocks: number;
  readonly truncated: boolean;
  /** The data of the page. */
  readonly data: Uint8Array;
}

/** A block as the text has it: index of the file, line from 1. */
export interface Place {
  readonly file: number;
  readonly line: number;
}

/** The answer if it has the right form. */
export function asPath(answer: unknown): Path | undefined {
  const { uri, files, blocks, truncated, data } = (answer ?? {}) as Partial<Record<keyof Path, unknown>>;
  if (typeof uri !== 'string' || !Array.isArray(files) || typeof data !== 'string') {
    return undefined;
  }
  return {
    uri,
    files: files.map((file: unknown) => (typeof file === 'string' ? file : undefined)),
    blocks: typeof blocks === 'number' ? blocks : 0,
    truncated: truncated === true,
    data: new Uint8Array(Buffer.from(data, 'base64')),
  };
}

/** The place that the page says was chosen, if the message says that. */
export function asSelected(message: unknown): Place | undefined {
  const { cnc872c, detail } = (message ?? {}) as { cnc872c?: unknown; detail?: Partial<Record<keyof Place, unknown>> };
  if (cnc872c !== 'select' || typeof detail?.file !== 'number' || typeof detail.line !== 'number') {
    return undefined;
  }
  return { file: detail.file, line: detail.line };
}

/** The page of the panel: nothing but the viewer, which comes with the extension, may run in it. */
export function pageOf(
  viewer: { script: string; styles: string; source: string },
  nonce: string,
  lang: string,
): string {
  const policy = [
    `default-src 'none'`,
    `script-src 'nonce-${nonce}'`,
    `style-src ${viewer.source} 'unsafe-inline'`,
    'img-src data: blob:',
  ].join('; ');
  return `<!doctype html>
<html lang="${lang}" data-lang="${lang}">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policy}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="stylesheet" href="${viewer.styles}">
</head>
<body>
<script nonce="${nonce}" src="${viewer.script}"></script>
</body>
</html>
`;
}

// What the grammar makes of the samples, and of lines that hold one thing each. Snapshots are written anew by
// `UPDATE=1 npm run test:grammar`.

import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';

import * as oniguruma from 'vscode-oniguruma';
import { INITIAL, type IGrammar, type IRawGrammar, Registry, parseRawGrammar } from 'vscode-textmate';

const GRAMMAR = 'syntaxes/cnc872.tmLanguage.json';
const SNAPSHOTS = 'test/grammar/snapshots';

/** Programs of samples/ whose colours are kept. */
const PROGRAMS = [
  'ok/flange.nc',
  'ok/groove-helix.nc',
  'ok/multiline.nc',
  'ok/nested-loops.nc',
  'ok/probing-table.nc',
  'ok/spindle-positioning.nc',
  'projects/drilling/bolt-circle.nc',
  'projects/drilling/macros/L9001',
  'projects/old-mill/gearbox.nc',
  'err/E0104-decimal-comma.nc',
  'err/E0105-typographic-quote.nc',
  'err/E0107-letter-for-digit.nc',
  'err/E0309-unknown-g-function.nc',
  'err/E0301-unknown-address.nc',
  'err/W0108-lowercase-address.nc',
  'err/W0110-text-after-end.nc',
];

async function load(): Promise<IGrammar> {
  const wasm = readFileSync(require.resolve('vscode-oniguruma/release/onig.wasm'));
  await oniguruma.loadWASM(wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength));
  const registry = new Registry({
    onigLib: Promise.resolve({
      createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
      createOnigString: (text) => new oniguruma.OnigString(text),
    }),
    loadGrammar: (): Promise<IRawGrammar> => Promise.resolve(parseRawGrammar(readFileSync(GRAMMAR, 'utf8'), GRAMMAR)),
  });
  const grammar = await registry.loadGrammar('source.cnc872');
  assert.ok(grammar);
  return grammar;
}

const grammar = load();

interface Token {
  readonly text: string;
  readonly from: number;
  /** The scopes below that of the language, without its name. */
  readonly scopes: string;
}

function tokens(lines: readonly string[], grammar: IGrammar): Token[][] {
  let stack = INITIAL;
  return lines.map((line) => {
    const result = grammar.tokenizeLine(line, stack);
    stack = result.ruleStack;
    return result.tokens
      .filter((token) => token.startIndex < line.length)
      .map((token) => ({
        text: line.slice(token.startIndex, token.endIndex),
        from: token.startIndex,
        scopes: token.scopes
          .slice(1)
          .map((scope) => scope.replace(/\.cnc872$/, ''))
          .join(' '),
      }));
  });
}

/** Each line, and under it a row of carets for each coloured part. */
function snapshot(text: string, grammar: IGrammar): string {
  const lines = text.split(/\r\n|\n|\r/);
  const coloured = tokens(lines, grammar);
  const rows = lines.flatMap((line, index) => [
    `>${line}`,
    ...(coloured[index] ?? [])
      .filter((token) => token.scopes !== '')
      .map((token) => `#${' '.repeat(token.from)}${'^'.repeat(token.text.length)} ${token.scopes}`),
  ]);
  return `${rows.join('\n')}\n`;
}

for (const program of PROGRAMS) {
  test(program, async () => {
    const text = readFileSync(path.join('../../samples', program), 'utf8');
    const now = snapshot(text, await grammar);
    const file = path.join(SNAPSHOTS, `${program.replaceAll('/', '--')}.snap`);
    if (process.env['UPDATE'] === '1') {
      writeFileSync(file, now);
    }
    assert.ok(existsSync(file), `${file} is missing: UPDATE=1 npm run test:grammar`);
    assert.equal(now, readFileSync(file, 'utf8'), `${file} differs: UPDATE=1 npm run test:grammar`);
  });
}

/** The coloured parts of one line of a program. */
async function line(text: string): Promise<[string, string][]> {
  const [, second = []] = tokens(['%1', text], await grammar);
  return second.filter((token) => token.scopes !== '').map((token) => [token.text, token.scopes]);
}

test('blanks between an address and its number', async () => {
  assert.deepEqual(await line('N 10 G\t01 X  -36.12'), [
    ['N 10', 'entity.name.label.block'],
    ['G\t01', 'keyword.other.motion'],
    ['X', 'variable.parameter.axis'],
    ['-36.12', 'constant.numeric.decimal'],
  ]);
});

test('nothing but letters and numbers side by side', async () => {
  assert.deepEqual(await line('N10G71L100Q3'), [
    ['N10', 'entity.name.label.block'],
    ['G71', 'keyword.control.flow'],
    ['L100', 'entity.name.function.target'],
    ['Q', 'variable.parameter.repeats'],
    ['3', 'constant.numeric.integer'],
  ]);
});

test('leading zeros', async () => {
  assert.deepEqual(await line('G001 G1 M003 G0100'), [
    ['G001', 'keyword.other.motion'],
    ['G1', 'keyword.other.motion'],
    ['M003', 'support.function.spindle'],
    ['G0100', 'invalid.illegal.g-function'],
  ]);
});

test('parameters', async () => {
  assert.deepEqual(await line('XR1R2=-R3 R4 5 GR5'), [
    ['X', 'variable.parameter.axis'],
    ['R1', 'variable.other.parameter'],
    ['R2', 'variable.other.parameter.assigned'],
    ['=', 'keyword.operator.assignment'],
    ['-', 'keyword.operator.sign'],
    ['R3', 'variable.other.parameter'],
    ['R4', 'variable.other.parameter.assigned'],
    ['5', 'constant.numeric.decimal'],
    ['G', 'keyword.other.g-function'],
    ['R5', 'variable.other.parameter'],
  ]);
});

test('a comment ends with its line', async () => {
  const [first, second] = tokens(['N10 "open X5', 'N20 X5'], await grammar);
  assert.equal(first?.at(-1)?.scopes, 'comment.block');
  assert.equal(second?.[0]?.scopes, 'entity.name.label.block');
});

test('what stands behind the end is not read', async () => {
  const [, , after] = tokens(['N10 M30', '* X5', 'N20 "text'], await grammar);
  assert.deepEqual(
    after?.map((token) => token.scopes),
    ['comment.block.unread'],
  );
});

test('what stands before the program is not read', async () => {
  const [first, second, third] = tokens(['KOVO drawing 3', 'N10', 'list 2 %5 N10'], await grammar);
  for (const line of [first, second]) {
    assert.deepEqual(
      line?.map((token) => token.scopes),
      ['comment.block.unread'],
    );
  }
  assert.equal(third?.at(-1)?.scopes, 'entity.name.label.block');
});

test('a macrocycle has nothing before it', async () => {
  const lines = tokens(['"title', '', 'N10 G79 L9001'], await grammar);
  assert.equal(lines[2]?.[0]?.scopes, 'entity.name.label.block');
});

test('an asterisk within a comment ends nothing', async () => {
  const [, second] = tokens(['"120 * 80"', 'N10'], await grammar);
  assert.equal(second?.[0]?.scopes, 'entity.name.label.block');
});

test('what cannot be right', async () => {
  assert.deepEqual(
    (await line('X36,12 E5 G20 M101 S12.5 (roughing)')).filter(([, scope]) => scope.startsWith('invalid')),
    [
      [',12', 'invalid.illegal.decimal-comma'],
      ['E', 'invalid.illegal.address'],
      ['5', 'invalid.illegal.number'],
      ['G20', 'invalid.illegal.g-function'],
      ['M101', 'invalid.illegal.m-function'],
      ['.5', 'invalid.illegal.number'],
      ['(roughing)', 'invalid.illegal.comment'],
    ],
  );
});

test('a letter that waits for its number is left alone', async () => {
  assert.deepEqual(await line('X G M R L -'), []);
});

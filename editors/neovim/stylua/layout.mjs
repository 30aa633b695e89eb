// The layout of the Lua files of the plugin, by StyLua:
//
//   npm run format    gives it to them
//   npm run check     fails when one has another

import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

import { Config, formatCode, IndentType, OutputVerification, QuoteStyle } from '@johnnymorganz/stylua';

const plugin = path.join(path.dirname(fileURLToPath(import.meta.url)), '..');
const check = process.argv.includes('--check');

function style() {
  const config = Config.new();
  config.column_width = 120;
  config.indent_type = IndentType.Spaces;
  config.indent_width = 2;
  config.quote_style = QuoteStyle.AutoPreferSingle;
  return config;
}

let wrong = 0;
for (const file of readdirSync(plugin, { recursive: true }).filter((file) => file.endsWith('.lua'))) {
  const text = readFileSync(path.join(plugin, file), 'utf8');
  // Each call takes its configuration with it.
  const laidOut = formatCode(text, style(), undefined, OutputVerification.Full);
  if (laidOut === text) {
    continue;
  }
  if (check) {
    wrong += 1;
    console.error(`editors/neovim/${file} has another layout: npm run format in editors/neovim/stylua`);
  } else {
    writeFileSync(path.join(plugin, file), laidOut);
  }
}
process.exitCode = wrong === 0 ? 0 : 1;

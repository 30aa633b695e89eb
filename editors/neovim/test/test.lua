-- The test of the plugin, run inside Neovim by `run`.

local WAIT = 20000

local plugin = require('cnc872c')
local failed = 0

local function say(text)
  io.stdout:write(text, '\n')
end

-- Runs one test; an error in it is its failure.
local function test(name, run)
  local ok, problem = pcall(run)
  if ok then
    say('ok      ' .. name)
  else
    failed = failed + 1
    say('FAILED  ' .. name .. '\n        ' .. tostring(problem):gsub('\n', '\n        '))
  end
end

local function equal(now, expected, what)
  if not vim.deep_equal(now, expected) then
    error(('%s\nis       %s\nexpected %s'):format(what or '', vim.inspect(now), vim.inspect(expected)), 0)
  end
end

local function until_true(what, condition)
  if not vim.wait(WAIT, condition, 20) then
    error('waited in vain: ' .. what, 0)
  end
end

local function lines()
  return vim.api.nvim_buf_get_lines(0, 0, -1, false)
end

-- Puts the cursor where `text` begins in the first line that holds `line`.
local function go(line, text)
  for number, content in ipairs(lines()) do
    if content:find(line, 1, true) then
      vim.api.nvim_win_set_cursor(0, { number, content:find(text or line, 1, true) - 1 })
      return
    end
  end
  error('no line with ' .. line, 0)
end

-- The findings of the buffer: code and place, in characters, from 1.
local function findings()
  local found = vim.tbl_map(function(diagnostic)
    local lsp = diagnostic.user_data and diagnostic.user_data.lsp or {}
    local column = function(line, byte)
      local content = vim.api.nvim_buf_get_lines(0, line, line + 1, false)[1] or ''
      return vim.fn.strchars(content:sub(1, byte)) + 1
    end
    return ('%s %d:%d-%d:%d'):format(
      diagnostic.code or lsp.code,
      diagnostic.lnum + 1,
      column(diagnostic.lnum, diagnostic.col),
      diagnostic.end_lnum + 1,
      column(diagnostic.end_lnum, diagnostic.end_col)
    )
  end, vim.diagnostic.get(0))
  table.sort(found)
  return found
end

local function codes()
  local found = vim.tbl_map(function(text)
    return text:match('^%S+')
  end, findings())
  return table.concat(found, ' ')
end

local function position()
  return vim.lsp.util.make_position_params(0, plugin.client().offset_encoding)
end

plugin.setup({ cmd = { vim.env.CNC872C, 'lsp' }, settings = { language = 'en' } })
vim.cmd('edit program.nc')
local original = lines()

test('names and first lines give the type of a file', function()
  local function filetype(name, text)
    vim.fn.writefile(text or { 'N1 G79 L9001' }, name)
    vim.cmd('noswapfile split ' .. name)
    local found = vim.bo.filetype
    vim.cmd('bwipeout!')
    return found
  end
  for _, name in ipairs({ 'a.nc', 'A.NC', 'a.ncp', 'a.mrc', 'L9001', 'l0005', 'L9001.TXT', 'L9001.MRC' }) do
    equal(filetype(name), 'cnc872', name)
  end
  equal(filetype('part', { '%12 "FLANGE"', 'N10 M30' }), 'cnc872', 'a first line with %')
  equal(filetype('L9001x'), '', 'L9001x')
  equal(filetype('notes', { '% of what' }), '', 'text with %')
  equal(filetype('a.tex', { '%1' }) ~= 'cnc872', true, 'another type')
  for _, name in ipairs({ 'a.nc', 'a.ncp', 'a.mrc', 'A.NC', 'L9001', 'l0005', 'L9001.TXT', 'L9001.MRC' }) do
    os.remove(name)
  end
end)

test('a file keeps its code page and its bytes', function()
  local function bytes(path)
    local file = assert(io.open(path, 'rb'))
    local content = file:read('*a')
    file:close()
    return content
  end
  local before = vim.o.fileencodings
  for _, case in ipairs({
    { '', '\216', 'ě', 'cp852' },
    { 'encoding = "windows-1250"', '\236', 'ě', 'cp1250' },
    { 'encoding = "kamenicky"', '\136', '\194\136', 'latin1' },
    { '', 'ě', 'ě', 'utf-8' },
  }) do
    local project, byte, letter, name = unpack(case)
    vim.fn.mkdir('pages', 'p')
    vim.fn.writefile({ project }, 'pages/cnc872c.toml')
    local content = '%1 "' .. byte .. '"\r\nN1 M30\r\n\26'
    local file = assert(io.open('pages/page.nc', 'wb'))
    file:write(content)
    file:close()
    vim.cmd('noswapfile split pages/page.nc')
    equal({ vim.bo.fileencoding, lines()[1] }, { name, '%1 "' .. letter .. '"' }, name)
    vim.cmd('silent write!')
    vim.cmd('bwipeout!')
    -- Neovim leaves out a Ctrl-Z behind the last line; for the control it means nothing.
    equal(bytes('pages/page.nc'), (content:gsub('\26$', '')), name)
  end
  equal(vim.o.fileencodings, before)
  vim.fn.delete('pages', 'rf')
end)

test('the syntax file colours the functions of the dictionary', function()
  local function group(line, text)
    go(line, text)
    local place = vim.api.nvim_win_get_cursor(0)
    return vim.fn.synIDattr(vim.fn.synID(place[1], place[2] + 1, 1), 'name')
  end
  for _, case in ipairs({
    { '%4711', '%4711', 'cnc872Program' },
    { '%4711', '"test', 'cnc872Comment' },
    { 'N10', 'N10', 'cnc872Block' },
    { 'N10', 'G90', 'cnc872Mode' },
    { 'N10', 'G0', 'cnc872Motion' },
    { 'N10', 'X0', 'cnc872Axis' },
    { 'N30', 'G71', 'cnc872Flow' },
    { 'N30', 'L100', 'cnc872Target' },
    { 'N70', 'G77', 'cnc872Unknown' },
    { 'N90', 'M30', 'cnc872Stop' },
    { '*', '*', 'cnc872End' },
  }) do
    equal(group(case[1], case[2]), case[3], case[2])
  end
end)

test('the server starts at the root of the project', function()
  until_true('a client', function()
    return plugin.client(0) ~= nil
  end)
  equal(plugin.client(0).config.root_dir, vim.loop.fs_realpath('.'))
end)

test('the findings are those of the command line', function()
  local expected = {}
  local report = vim.fn.json_decode(vim.fn.readfile(vim.env.EXPECTED))
  for _, finding in ipairs(report.diagnostics) do
    local from, to = finding.span.start, finding.span['end']
    table.insert(expected, ('%s %d:%d-%d:%d'):format(finding.code, from.line, from.column, to.line, to.column))
  end
  table.sort(expected)
  assert(#expected > 2, 'the command line finds something')
  pcall(until_true, 'the findings', function()
    return #vim.diagnostic.get(0) == #expected
  end)
  equal(findings(), expected)
end)

test('a hover says what a function does', function()
  go('N20', 'G1')
  local hover = plugin.request('textDocument/hover', position())
  local text = hover and (hover.contents.value or hover.contents) or ''
  assert(text:find('linear interpolation', 1, true), vim.inspect(hover))
end)

test('the definition of a call is the entry of the subprogram', function()
  go('G71 L100', 'L100')
  vim.lsp.buf.definition()
  until_true('the cursor in N100', function()
    return vim.api.nvim_get_current_line():match('^N100 ') ~= nil
  end)
end)

test('the definition of a jump is the block', function()
  go('G73 L40', 'L40')
  vim.lsp.buf.definition()
  until_true('the cursor in N40', function()
    return vim.api.nvim_get_current_line():match('^N40 ') ~= nil
  end)
end)

test('a block number is renamed with the jumps to it', function()
  go('N40', '40')
  vim.lsp.buf.rename('45')
  local expected = vim.tbl_map(function(line)
    return (line:gsub('^N40 ', 'N45 '):gsub('L40 ', 'L45 '))
  end, original)
  pcall(until_true, 'the new number', function()
    return not vim.deep_equal(lines(), original)
  end)
  equal(lines(), expected)
  vim.cmd('silent undo')
  equal(lines(), original)
end)

test('behind G71 L the subprograms are offered', function()
  go('N40')
  vim.api.nvim_buf_set_lines(0, 4, 4, false, { 'N35 G71 L' })
  vim.api.nvim_win_set_cursor(0, { 5, 0 })
  local params = position()
  params.position.character = #'N35 G71 L'
  local result = plugin.request('textDocument/completion', params)
  local items = result and (result.items or result) or {}
  local offered = vim.tbl_filter(function(item)
    local text = item.textEdit and item.textEdit.newText or item.insertText or item.label
    return text:find('100', 1, true) ~= nil
  end, items)
  vim.cmd('silent undo')
  equal(#offered, 1, vim.inspect(items))
end)

test('findings follow the text', function()
  until_true('the old findings', function()
    return codes() == 'E0104 E0306 E0309 E0602'
  end)
  vim.api.nvim_buf_set_lines(0, 7, 9, false, { 'N70 "žlutá příruba" G1 X1.5', 'N80 X2' })
  until_true('findings without those mended', function()
    return not codes():find('E0104', 1, true) and not codes():find('E03', 1, true)
  end)
  vim.api.nvim_buf_set_lines(0, 4, 4, false, { 'N35 X1 Y2 E5' })
  until_true('a new finding', function()
    return codes():find('E0301', 1, true) ~= nil
  end)
  vim.api.nvim_buf_set_lines(0, 0, -1, false, original)
  until_true('the old findings', function()
    return codes() == 'E0104 E0306 E0309 E0602'
  end)
end)

test('the project file is looked after too', function()
  vim.cmd('split cnc872c.toml')
  until_true('no findings', function()
    return plugin.client(0) ~= nil and #vim.diagnostic.get(0) == 0
  end)
  vim.api.nvim_buf_set_lines(0, -1, -1, false, { 'no-such-key = 1' })
  until_true('a finding in text that is not saved', function()
    return codes() == 'W0705'
  end)
  vim.cmd('bwipeout!')
  until_true('the old findings', function()
    return codes() == 'E0104 E0306 E0309 E0602'
  end)
end)

test('CncExplain shows the page of the finding under the cursor, and of a code', function()
  go('G77', 'G77')
  vim.cmd('CncExplain')
  equal(vim.api.nvim_buf_get_name(0):match('cnc872c:.*'), 'cnc872c:/explain/en/E0309.md')
  equal({ vim.bo.filetype, vim.bo.modifiable, vim.bo.buftype }, { 'markdown', false, 'nofile' })
  assert(#lines() > 5 and lines()[1]:find('E0309', 1, true), vim.inspect(lines()))
  vim.cmd('close')
  vim.cmd('CncExplain e0306')
  assert(lines()[1]:find('E0306', 1, true), vim.inspect(lines()))
  vim.cmd('close')
end)

test('CncFixAll mends what can be mended', function()
  vim.cmd('CncFixAll')
  local expected = vim.tbl_map(function(line)
    return (line:gsub('X1,5', 'X1.5'))
  end, original)
  equal(lines(), expected)
end)

test('formatting changes what is loose; the cursor and all other lines stay', function()
  local loose = {
    '%4711 "test of an editor"',
    'N10 G90 G00 X0 Y0',
    'n20  g1 X10   F200',
    'N30 X-  5',
    'N40 X20 "ř  "  Y 5',
    'N50 M30 "Neovim 0.7 wants it long"',
  }
  vim.api.nvim_buf_set_lines(0, 0, -1, false, loose)
  vim.api.nvim_win_set_cursor(0, { 5, #'N40 X20 "ř  "  ' })
  local changed = {}
  vim.api.nvim_buf_attach(0, false, {
    on_lines = function(_, _, _, first, last)
      for line = first + 1, last do
        changed[line] = true
      end
      return false
    end,
  })
  if vim.lsp.buf.format then
    vim.lsp.buf.format({ timeout_ms = WAIT })
  else
    vim.lsp.buf.formatting_sync({}, WAIT)
  end
  local expected = { loose[1], loose[2], 'N20 G01 X10 F200', 'N30 X-  5', 'N40 X20 "ř  " Y5', loose[6] }
  equal(lines(), expected)
  local touched = vim.tbl_keys(changed)
  table.sort(touched)
  equal(touched, { 3, 5 }, 'changed lines')
  equal(vim.api.nvim_win_get_cursor(0), { 5, #'N40 X20 "ř  " ' })
end)

test('CncRenumber numbers the blocks anew, and the jumps to them', function()
  local numbered =
    { '%4711 "test of an editor"', 'N1 G90 G0 X0 Y0', 'N2 G1 X10 F200', 'N7 X20', 'N9 G73 L7 Q2', 'N11 M30' }
  vim.api.nvim_buf_set_lines(0, 0, -1, false, numbered)
  until_true('no findings', function()
    return #vim.diagnostic.get(0) == 0
  end)
  vim.cmd('CncRenumber')
  local expected =
    { '%4711 "test of an editor"', 'N10 G90 G0 X0 Y0', 'N20 G1 X10 F200', 'N30 X20', 'N40 G73 L30 Q2', 'N50 M30' }
  equal(lines(), expected)
end)

test('CncStream shows the records', function()
  vim.cmd('CncStream')
  equal({ vim.bo.filetype, vim.bo.buftype }, { 'json', 'nofile' })
  local records = vim.tbl_map(vim.fn.json_decode, lines())
  equal({ records[1].kind, records[#records].kind }, { 'program', 'end' })
  vim.cmd('close')
end)

test('CncSignals shows what the PLC reads in a block', function()
  vim.api.nvim_win_set_cursor(0, { 2, 0 })
  vim.cmd('CncSignals')
  equal({ vim.bo.buftype, vim.bo.modifiable }, { 'nofile', false })
  local text = table.concat(lines(), '\n')
  equal(lines()[1], 'N10 G90 G0 X0 Y0')
  equal(text:find('BLK.FirstBlock=1', 1, true) ~= nil, true)
  vim.cmd('close')
end)

-- Chooses the item at that place wherever the plugin asks, while `run` runs.
local function choosing(at, run)
  local select = vim.ui.select
  vim.ui.select = function(items, _, done)
    done(items[at])
  end
  local ok, problem = pcall(run)
  vim.ui.select = select
  if not ok then
    error(problem, 0)
  end
end

test('CncState shows what holds at a block, in the pass that is chosen', function()
  go('N30 X20')
  choosing(2, function()
    vim.cmd('CncState')
  end)
  equal({ vim.bo.buftype, vim.bo.modifiable }, { 'nofile', false })
  equal(lines()[1]:match('^Before N30 %(line 4, seq %d+%)'), lines()[1]:match('^Before [^)]*%)'))
  local text = table.concat(lines(), '\n')
  equal(text:find('N40 (line 5): 1 of 2 left', 1, true) ~= nil, true, text)
  vim.cmd('close')
end)

test('CncStart opens a program that starts at a block', function()
  go('N30 X20')
  choosing(2, function()
    vim.cmd('CncStart 50')
  end)
  equal({ vim.bo.filetype, vim.bo.modifiable }, { 'cnc872', true })
  equal(lines()[1], '%4711 "program.nc from N30, pass 2"')
  equal(table.concat(lines(), '\n'):find('move it clear by hand first', 1, true) ~= nil, true)
  vim.cmd('bwipeout!')
end)

test('references that a lens names go to the quickfix list', function()
  local uri = vim.uri_from_bufnr(0)
  local place = { start = { line = 3, character = 4 }, ['end'] = { line = 3, character = 7 } }
  local command =
    { command = 'cnc872c.showReferences', arguments = { uri, place.start, { { uri = uri, range = place } } } }
  vim.lsp.commands['cnc872c.showReferences'](command, { client_id = plugin.client().id })
  local list = vim.fn.getqflist()
  equal({ #list, list[1].lnum, list[1].col }, { 1, 4, 5 })
  vim.cmd('cclose')
end)

test('blocks become comments and come back', function()
  local before = { 'N20  T1 M06  "Freza D16"', '', "N30 X1 \"it's ^ 5'" }
  vim.cmd('enew')
  vim.api.nvim_buf_set_lines(0, 0, -1, false, before)
  plugin.toggle_comment(1, 3)
  equal(vim.api.nvim_buf_get_lines(0, 0, 2, false), { '"// N20  T1 M06  \'Freza D16\'"', '' })
  plugin.toggle_comment(1, 3)
  equal(vim.api.nvim_buf_get_lines(0, 0, -1, false), before)
  vim.cmd('bwipeout!')
end)

test('no line that becomes a comment gets longer than 80 characters', function()
  local before = {
    'N20 G01 X1.125 Y2.250 Z3.375 F1000 S2000 M03 "hrubování kapsy, čtvrtý průchod, T7"',
    'N30' .. (' X1'):rep(25),
  }
  vim.cmd('enew')
  vim.api.nvim_buf_set_lines(0, 0, -1, false, before)
  plugin.toggle_comment(1, 2)
  local off = vim.api.nvim_buf_get_lines(0, 0, -1, false)
  equal(#off, 4)
  for at, line in ipairs(off) do
    equal(vim.fn.strchars(line) <= 80, true, line)
    equal(line:match('^"//%+?'), at % 2 == 0 and '"//+' or '"//')
  end
  -- A part of what was one line brings all of it back.
  plugin.toggle_comment(1, 1)
  equal(vim.api.nvim_buf_get_lines(0, 0, 1, false), { before[1] })
  plugin.toggle_comment(3, 3)
  equal(vim.api.nvim_buf_get_lines(0, 0, -1, false), before)
  vim.cmd('bwipeout!')
end)

test('newer Neovims get the same as a configuration', function()
  local given, enabled
  local config, enable = vim.lsp.config, vim.lsp.enable
  vim.lsp.config, vim.lsp.enable =
    function(name, table)
      given = { name, table }
    end, function(name)
      enabled = name
    end
  plugin.setup({ cmd = { 'server' }, settings = { dialect = 'cnc8x6', limits = { records = 5 } } })
  vim.lsp.config, vim.lsp.enable = config, enable
  equal({ given[1], enabled }, { 'cnc872c', 'cnc872c' })
  equal(given[2].cmd, { 'server' })
  equal(given[2].filetypes, { 'cnc872', 'toml' })
  equal(given[2].init_options, { language = 'auto', dialect = 'cnc8x6', limits = { records = 5 } })
  equal(given[2].settings.cnc872c, given[2].init_options)
  equal(given[2].capabilities.experimental.commands.commands, { 'cnc872c.showReferences', 'cnc872c.stateHere' })
  local root
  given[2].root_dir(vim.fn.bufnr('program.nc'), function(folder)
    root = folder
  end)
  equal(root, vim.loop.fs_realpath('.'))
end)

if failed > 0 then
  say(('%d tests failed'):format(failed))
  vim.cmd('cquit 1')
end
say('all passed')
vim.cmd('qall!')

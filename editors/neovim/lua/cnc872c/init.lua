-- The language server of cnc872c in Neovim 0.7 and newer: require('cnc872c').setup{}

local M = {}

local NAME = 'cnc872c'

M.defaults = {
  -- How the server is started.
  cmd = { 'cnc872c', 'lsp' },
  -- Values that win over the project file, named as in it.
  settings = { language = 'auto' },
  -- Called with client and buffer when the server looks after a buffer.
  on_attach = nil,
  -- What another plugin adds to the capabilities, for instance one for completion.
  capabilities = nil,
}

M.options = vim.deepcopy(M.defaults)

-- Names of code pages: those of the project file, and what Neovim calls them. Neovim does not know the Kamenický code:
-- its letters are shown as others, and every byte stays what it is.
local CODE_PAGES = {
  ['cp852'] = 'cp852',
  ['windows-1250'] = 'cp1250',
  ['iso-8859-2'] = 'iso-8859-2',
  ['kamenicky'] = 'latin1',
}

---- Blocks as comments ----

-- A comment never crosses a line end, so each line becomes a comment, `"// …"`; the quotes in it become apostrophes and come
-- back. What does not fit into the 80 characters of a line (LEX-7) follows in lines of `"//+ …"`.
local LINE = 80

local function switched_off(line)
  local indent, more, inside, rest = line:match('^(%s*)"//(%+?) (.*)"(%s*)$')
  if inside and not inside:find('"', 1, true) then
    return indent, inside, rest, more == '+'
  end
end

local function continues(line)
  local _, _, _, more = switched_off(line or '')
  return more == true
end

-- As much of a text as fits, up to behind its last blank if there is one; a pair with `^` stays together.
local function head(text, room)
  local length, width, blank = 0, 0, 0
  while length < #text do
    local unit = text:match("^%^[%^']", length + 1)
      or text:match('^[%z\1-\127\194-\244][\128-\191]*', length + 1)
      or text:sub(length + 1, length + 1)
    width = width + vim.fn.strchars(unit)
    if width > room then
      return text:sub(1, blank > 0 and blank or length)
    end
    length = length + #unit
    if unit == ' ' then
      blank = length
    end
  end
  return text
end

-- Adds the comments that the line becomes to `lines`.
local function switch_off(line, lines)
  local indent, text, rest = line:match('^(%s*)(.-)(%s*)$')
  local inside = text:gsub('[%^\'"]', { ['^'] = '^^', ["'"] = "^'", ['"'] = "'" })
  local begin, part = indent .. '"// ', nil
  repeat
    part = head(inside, math.max(LINE - vim.fn.strchars(begin) - 1, 2))
    inside = inside:sub(#part + 1)
    table.insert(lines, begin .. part .. '"')
    begin = indent .. '"//+ '
  until inside == ''
  -- Blanks at the end of the line are kept where they make it no longer than it was.
  if vim.fn.strchars(lines[#lines]) + #rest <= LINE then
    lines[#lines] = lines[#lines] .. rest
  end
end

-- Adds the line that became that comment to `lines`, or to the last of them.
local function switch_on(line, lines, goes_on)
  local indent, inside, rest, more = switched_off(line)
  local text = inside:gsub("%^?[%^']", { ['^^'] = '^', ["^'"] = "'", ["'"] = '"' }) .. rest
  if more and goes_on then
    lines[#lines] = lines[#lines] .. text
  else
    table.insert(lines, (more and '' or indent) .. text)
  end
end

-- Makes the lines comments, or blocks again when all of them are such comments; empty lines stay.
function M.toggle_comment(first, last)
  -- All comments that were one line go together.
  local at = function(number)
    return vim.api.nvim_buf_get_lines(0, number - 1, number, false)[1]
  end
  while first > 1 and continues(at(first)) do
    first = first - 1
  end
  while continues(at(last + 1)) do
    last = last + 1
  end
  local lines = vim.api.nvim_buf_get_lines(0, first - 1, last, false)
  local all, any = true, false
  for _, line in ipairs(lines) do
    if line:match('%S') then
      any = true
      all = all and switched_off(line) ~= nil
    end
  end
  local changed, goes_on = {}, false
  for _, line in ipairs(lines) do
    if not line:match('%S') then
      table.insert(changed, line)
      goes_on = false
    elseif all and any then
      switch_on(line, changed, goes_on)
      goes_on = true
    else
      switch_off(line, changed)
    end
  end
  vim.api.nvim_buf_set_lines(0, first - 1, first - 1 + #lines, false, changed)
end

---- Files and their folders ----

local function parent(path)
  return vim.fn.fnamemodify(path, ':p:h')
end

-- The file `name` in a folder or above it; nil when there is none.
local function above(name, folder)
  local found = vim.fn.findfile(name, vim.fn.fnameescape(folder) .. ';')
  return found ~= '' and vim.fn.fnamemodify(found, ':p') or nil
end

-- The root of a file: where its project file is, else its repository, else its folder.
function M.root(path)
  local folder = parent(path)
  local project = above('cnc872c.toml', folder)
  if project then
    return parent(project)
  end
  local repository = vim.fn.finddir('.git', vim.fn.fnameescape(folder) .. ';')
  if repository ~= '' then
    return vim.fn.fnamemodify(repository, ':p:h:h')
  end
  return folder
end

-- The code page of a file that is not UTF-8: by the settings, else by the project file, else CP852.
function M.encoding(path)
  local name = M.options.settings.encoding
  local project = not name and above('cnc872c.toml', parent(path))
  if project then
    for _, line in ipairs(vim.fn.readfile(project)) do
      name = name or line:match('^%s*encoding%s*=%s*["\']([%w%-]+)["\']')
    end
  end
  return CODE_PAGES[(name or ''):lower()] or 'cp852'
end

-- 'fileencodings' is one for all buffers: it is ours while a part program is read.
local function encodings(group)
  local pattern = { '*.nc', '*.NC', '*.ncp', '*.NCP', '*.mrc', '*.MRC', '[lL][0-9]*' }
  local before
  vim.api.nvim_create_autocmd('BufReadPre', {
    group = group,
    pattern = pattern,
    callback = function(args)
      before = before or vim.o.fileencodings
      vim.o.fileencodings = 'ucs-bom,utf-8,' .. M.encoding(args.match)
    end,
  })
  vim.api.nvim_create_autocmd('BufReadPost', {
    group = group,
    pattern = pattern,
    callback = function()
      vim.o.fileencodings, before = before or vim.o.fileencodings, nil
    end,
  })
end

---- The client, in old and new Neovim ----

-- Methods of clients took no `self` before 0.11.
local function method(client, name, ...)
  if vim.fn.has('nvim-0.11') == 1 then
    return client[name](client, ...)
  end
  return client[name](...)
end

local function clients(filter)
  local all = (vim.lsp.get_clients or vim.lsp.get_active_clients)()
  return vim.tbl_filter(function(client)
    return client.name == NAME and (not filter or filter(client))
  end, all)
end

-- The server of a buffer; any one when the buffer has none.
function M.client(buffer)
  buffer = buffer or vim.api.nvim_get_current_buf()
  local own = clients(function(client)
    return vim.lsp.buf_is_attached(buffer, client.id)
  end)
  return own[1] or clients()[1]
end

-- Asks the server and waits for its answer; nil, and a message, when there is none.
function M.request(name, params, buffer)
  -- Not 0: by the number of the buffer changes are found that the server was not told yet.
  buffer = buffer or vim.api.nvim_get_current_buf()
  local client = M.client(buffer)
  if not client then
    vim.notify('cnc872c: no server looks after this buffer', vim.log.levels.WARN)
    return nil
  end
  local answer, problem = method(client, 'request_sync', name, params, 10000, buffer)
  problem = problem or (answer and answer.err and answer.err.message)
  if problem then
    vim.notify('cnc872c: ' .. problem, vim.log.levels.ERROR)
    return nil
  end
  return answer and answer.result, client
end

local function capabilities()
  local own = vim.lsp.protocol.make_client_capabilities()
  own = vim.tbl_deep_extend('force', own, M.options.capabilities or {})
  return vim.tbl_deep_extend('force', own, {
    workspace = { textDocumentContent = { dynamicRegistration = false } },
    experimental = { commands = { commands = { 'cnc872c.showReferences', 'cnc872c.stateHere' } } },
  })
end

-- What both kinds of configuration say.
function M.config()
  local settings = M.options.settings
  return {
    name = NAME,
    cmd = M.options.cmd,
    filetypes = { 'cnc872', 'toml' },
    init_options = settings,
    settings = { [NAME] = settings },
    capabilities = capabilities(),
    on_attach = M.options.on_attach,
  }
end

-- Whether the server looks after a buffer: one with a part program, or the project file.
local function is_ours(buffer)
  local path = vim.api.nvim_buf_get_name(buffer)
  local project = vim.fn.fnamemodify(path, ':t') == 'cnc872c.toml'
  return path ~= '' and vim.bo[buffer].buftype == '' and (project or vim.bo[buffer].filetype == 'cnc872')
end

-- Before 0.11: starts the server of a buffer, or takes the one that its root has.
local function attach(buffer)
  if not is_ours(buffer) then
    return
  end
  local root = M.root(vim.api.nvim_buf_get_name(buffer))
  local running = clients(function(client)
    return client.config.root_dir == root
  end)[1]
  local id = running and running.id
  if not id then
    local config = M.config()
    config.root_dir = root
    config.workspace_folders = { { uri = vim.uri_from_fname(root), name = root } }
    id = vim.lsp.start_client(config)
  end
  if id then
    vim.lsp.buf_attach_client(buffer, id)
  end
end

---- Pages of findings ----

-- The finding under the cursor, else the first one of the line.
local function finding()
  local place = vim.api.nvim_win_get_cursor(0)
  local found = vim.diagnostic.get(0, { lnum = place[1] - 1 })
  table.sort(found, function(a, b)
    return a.col < b.col
  end)
  for _, diagnostic in ipairs(found) do
    if diagnostic.col <= place[2] and place[2] < math.max(diagnostic.end_col or 0, diagnostic.col + 1) then
      return diagnostic
    end
  end
  return found[1]
end

local function language()
  local own = M.options.settings.language
  if own == 'cs' or own == 'en' then
    return own
  end
  return (vim.v.lang or ''):match('^cs') and 'cs' or 'en'
end

-- Shows the page of a finding: of `code`, else of the finding under the cursor.
function M.explain(code)
  local uri
  if not code or code == '' then
    local diagnostic = finding()
    if not diagnostic then
      vim.notify('cnc872c: no finding in this line', vim.log.levels.INFO)
      return
    end
    local lsp = diagnostic.user_data and diagnostic.user_data.lsp or {}
    code = diagnostic.code or lsp.code
    uri = lsp.codeDescription and lsp.codeDescription.href
  end
  vim.cmd('split ' .. vim.fn.fnameescape(uri or ('cnc872c:/explain/%s/%s.md'):format(language(), code:upper())))
end

-- Fills the current buffer, whose name is the URI of a document of the server's.
local function read_document(args)
  local buffer = args.buf
  -- Some Neovims take the URI for a path, and put the current folder before it.
  local uri = args.match:match('cnc872c:/.*$')
  local result = M.request('workspace/textDocumentContent', { uri = uri }, buffer)
  vim.api.nvim_buf_set_lines(buffer, 0, -1, false, vim.split(result and result.text or '', '\n'))
  vim.bo[buffer].buftype = 'nofile'
  vim.bo[buffer].bufhidden = 'wipe'
  vim.bo[buffer].swapfile = false
  vim.bo[buffer].modifiable = false
  vim.bo[buffer].filetype = 'markdown'
end

---- Other commands ----

-- Applies the first action of that kind for the whole buffer.
function M.act(kind)
  local buffer = vim.api.nvim_get_current_buf()
  local last = vim.api.nvim_buf_line_count(buffer)
  local document = vim.lsp.util.make_text_document_params(buffer)
  local actions, client = M.request('textDocument/codeAction', {
    textDocument = document,
    range = { start = { line = 0, character = 0 }, ['end'] = { line = last, character = 0 } },
    context = { diagnostics = {}, only = { kind } },
  }, buffer)
  local action = actions and actions[1]
  if not action then
    vim.notify('cnc872c: nothing to do', vim.log.levels.INFO)
    return
  end
  if not action.edit and action.data then
    action = M.request('codeAction/resolve', action, buffer) or action
  end
  if action.edit then
    vim.lsp.util.apply_workspace_edit(action.edit, client.offset_encoding)
  end
  local command = type(action.command) == 'table' and action.command or nil
  if command then
    M.request('workspace/executeCommand', { command = command.command, arguments = command.arguments }, buffer)
  end
end

-- Shows a text of the server in a buffer of its own.
local function show(text)
  vim.cmd('new')
  local buffer = vim.api.nvim_get_current_buf()
  vim.bo[buffer].buftype = 'nofile'
  vim.bo[buffer].bufhidden = 'wipe'
  vim.bo[buffer].swapfile = false
  vim.api.nvim_buf_set_lines(buffer, 0, -1, false, vim.split((text:gsub('\n$', '')), '\n'))
  vim.bo[buffer].modifiable = false
end

-- Shows the block stream of the program, one record a line.
function M.stream()
  local uri = vim.uri_from_bufnr(0)
  local result = M.request('workspace/executeCommand', { command = 'cnc872c.stream', arguments = { uri } })
  if type(result) ~= 'table' then
    return
  end
  show(result.text)
  vim.bo.filetype = 'json'
  if result.truncated then
    vim.notify('cnc872c: only the beginning of the stream is shown', vim.log.levels.INFO)
  end
end

-- Shows what the PLC reads in the block at the cursor.
function M.signals()
  local client = M.client(vim.api.nvim_get_current_buf())
  local result = M.request('cnc872c/signals', vim.lsp.util.make_position_params(0, client and client.offset_encoding))
  if type(result) ~= 'table' then
    return
  end
  show(result.text)
end

-- Asks about a place until the server gives a text: of several executions the user chooses one, and a height that is missing
-- is typed. A refusal is shown, and the nearest place that works is offered. `done` gets the answer.
local about_place
function about_place(name, params, done)
  local function again(more)
    return about_place(name, vim.tbl_extend('force', params, more), done)
  end
  local result = M.request(name, params)
  if type(result) ~= 'table' then
    if result == vim.NIL then
      vim.notify('cnc872c: no block here', vim.log.levels.INFO)
    end
  elseif result.text then
    done(result)
  elseif result.passes then
    vim.ui.select(result.passes, {
      prompt = result.message,
      format_item = function(pass)
        return pass.pass .. '  ' .. pass.text
      end,
    }, function(pass)
      return pass and again({ seq = pass.seq })
    end)
  elseif result.safe then
    vim.ui.input({ prompt = result.safe .. ' [mm]: ' }, function(height)
      return height and height ~= '' and again({ safe = height })
    end)
  elseif result.refused then
    vim.notify('cnc872c: ' .. result.refused, vim.log.levels.WARN)
    local nearest = result.nearest
    if type(nearest) == 'table' then
      local there = ('N%d, seq %d'):format(nearest.n, nearest.seq)
      vim.ui.select({ there }, { prompt = 'cnc872c' }, function(chosen)
        return chosen and again({ seq = nearest.seq })
      end)
    end
  end
end

local function place_of_cursor()
  local client = M.client(vim.api.nvim_get_current_buf())
  local params = vim.lsp.util.make_position_params(0, client and client.offset_encoding)
  return { textDocument = params.textDocument, position = params.position }
end

-- Shows what holds before the block at the cursor, or at `place`.
function M.state(place)
  about_place('cnc872c/state', place or place_of_cursor(), function(result)
    show(result.text)
  end)
end

-- Opens a program that starts at the block at the cursor beside the program; `safe`: where the tool is clear of everything.
function M.start(safe)
  local params = place_of_cursor()
  params.safe = safe ~= '' and safe or nil
  about_place('cnc872c/restart', params, function(result)
    vim.cmd('vnew')
    vim.api.nvim_buf_set_lines(0, 0, -1, false, vim.split((result.text:gsub('\r\n', '\n'):gsub('\n$', '')), '\n'))
    vim.bo.fileformat = result.text:find('\r\n', 1, true) and 'dos' or 'unix'
    vim.bo.filetype = 'cnc872'
    if type(result.message) == 'string' then
      vim.notify('cnc872c: ' .. result.message, vim.log.levels.INFO)
    end
  end)
end

-- What a lens above a tool change asks for.
function M.state_here(command)
  local uri, position = unpack(command.arguments)
  M.state({ textDocument = { uri = uri }, position = position })
end

-- What a lens above a subprogram asks for: its calls, in the quickfix list.
function M.show_references(command, context)
  local _, _, locations = unpack(command.arguments)
  local client = vim.lsp.get_client_by_id(context.client_id)
  local items = vim.lsp.util.locations_to_items(locations, client.offset_encoding)
  vim.fn.setqflist({}, ' ', { title = command.title or NAME, items = items })
  vim.cmd('botright copen')
end

---- Set-up ----

function M.setup(options)
  M.options = vim.tbl_deep_extend('force', vim.deepcopy(M.defaults), options or {})
  local group = vim.api.nvim_create_augroup(NAME, { clear = true })
  encodings(group)
  vim.lsp.commands['cnc872c.showReferences'] = M.show_references
  vim.lsp.commands['cnc872c.stateHere'] = M.state_here
  vim.api.nvim_create_autocmd('BufReadCmd', { group = group, pattern = 'cnc872c:/*', callback = read_document })

  local command = vim.api.nvim_create_user_command
  command('CncExplain', function(arguments)
    M.explain(arguments.args)
  end, { nargs = '?', desc = 'The page of a finding' })
  command('CncRenumber', function()
    M.act('source.renumber.cnc872c')
  end, { desc = 'Number the blocks anew' })
  command('CncFixAll', function()
    M.act('source.fixAll.cnc872c')
  end, { desc = 'Mend what can be mended' })
  command('CncStream', M.stream, { desc = 'The block stream of the program' })
  command('CncSignals', M.signals, { desc = 'The PLC signals of the block at the cursor' })
  command('CncState', function()
    M.state()
  end, { desc = 'What holds at the block at the cursor' })
  command('CncStart', function(arguments)
    M.start(arguments.args)
  end, { nargs = '?', desc = 'A program that starts at the block at the cursor' })

  if vim.lsp.config and vim.lsp.enable then
    local config = M.config()
    config.root_dir = function(buffer, done)
      if is_ours(buffer) then
        done(M.root(vim.api.nvim_buf_get_name(buffer)))
      end
    end
    vim.lsp.config(NAME, config)
    vim.lsp.enable(NAME)
  else
    vim.api.nvim_create_autocmd('FileType', {
      group = group,
      pattern = { 'cnc872', 'toml' },
      callback = function(args)
        attach(args.buf)
      end,
    })
  end
end

return M

" Settings of buffers with part programs.
if exists('b:did_ftplugin')
  finish
endif
let b:did_ftplugin = 1

" A quote in the line would end the comment early, so the built-in commands get nothing to work with; gcc below does it.
setlocal commentstring=
setlocal comments=
setlocal formatoptions-=t formatoptions-=c formatoptions-=r formatoptions-=o
" A last line without a line end stays as it is.
setlocal nofixendofline

" Switches blocks off and on again, line by line.
nnoremap <buffer> <silent> gcc <Cmd>lua require('cnc872c').toggle_comment(vim.fn.line('.'), vim.fn.line('.') + vim.v.count1 - 1)<CR>
xnoremap <buffer> <silent> gc :<C-u>lua require('cnc872c').toggle_comment(vim.fn.line("'<"), vim.fn.line("'>"))<CR>

let b:undo_ftplugin = 'setlocal commentstring< comments< formatoptions< fixendofline< | silent! nunmap <buffer> gcc | silent! xunmap <buffer> gc'

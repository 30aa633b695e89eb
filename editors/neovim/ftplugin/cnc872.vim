" Settings of buffers with part programs.
if exists('b:did_ftplugin')
  finish
endif
let b:did_ftplugin = 1

" A comment may be closed or go on to the end of the line.
setlocal commentstring=\"%s\"
setlocal comments=
setlocal formatoptions-=t formatoptions-=c formatoptions-=r formatoptions-=o
" A last line without a line end stays as it is.
setlocal nofixendofline

let b:undo_ftplugin = 'setlocal commentstring< comments< formatoptions< fixendofline<'

" Part programs by their names: programs, and macrocycles, whose name is L and a number; else by a first line with % and a
" number. Neovim takes *.nc for something else, so the type is set whatever it was.
autocmd BufNewFile,BufRead *.nc,*.NC,*.ncp,*.NCP,*.mrc,*.MRC set filetype=cnc872
autocmd BufNewFile,BufRead [lL][0-9]*
      \ if expand('<afile>:t') =~? '^l\d\+\(\.txt\)\=$' | set filetype=cnc872 | endif
autocmd BufNewFile,BufRead *
      \ if &filetype ==# '' && getline(1) =~# '^\s*%\s*\d\+\s*\($\|"\|[Nn]\)' | set filetype=cnc872 | endif

%1020 "LEX-9 nothing there is an error, not even a second start
N10 G90 G0 X0 Y0
N20 M30
* %
" ^ W0110
"done

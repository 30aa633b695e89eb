%309 "G z jineho systemu
"GRP-1 a G that is in no group
N10 G21 G90 G49 G40
"    ^^ E0309
"            ^^ E0309
N20 G43 Z100 H1
"    ^^ E0309
N30 G0 X0 Y0 G99
"             ^^ E0309
N40 G13 X5
"    ^^ E0309
N50 M30

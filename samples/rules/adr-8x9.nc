"! dialect=cnc8x9
%4 "CNC8x9: H 1 to 99, M 0 to 99
N10 G90 G0 X0 Y0 H99 M99
N20 H0 X5
"    ^ E0302
N30 H100 X6
"    ^^^ E0302
N40 H1.5 X7
"    ^^^ E0304
N50 H-1 X8
"    ^^ E0305
N60 M100 X9
"    ^^^ E0302
N70 A1 B1 C1 U1 V1 W1 "ADR-4 A B C come first beside X, Y, Z
"            ^^ E0311
"               ^^ E0311
"                  ^^ E0311
N75 X20 WR1 A2 "each word of them, in the order of the text
"       ^^^ E0311
N80 M30

"! dialect=cnc8x6
%5 "CNC8x6: as CNC8x9
N10 G90 G0 X0 Y0 H99 M99
N20 H0 X5
"    ^ E0302
N30 H1.5 X7
"    ^^^ E0304
N40 M100 X9
"    ^^^ E0302
N50 A1 U1 V1 W1 C1 "ADR-4 A, U and V come first beside X, Y, Z
"            ^^ E0311
"               ^^ E0311
N60 M30

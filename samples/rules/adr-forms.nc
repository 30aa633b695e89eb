%3 "ADR-1 point and sign; one code a word: sign, point, range
N10 G90 G0. X.5 Y-.5
"        ^^ E0304
N20 M-3.5 X1
"    ^^^^ E0305
N30 G100.5 X2
"    ^^^^^ E0304
N40 S800. T+5
"    ^^^^ E0304
"          ^^ E0305
N50 D-0 P1.
"    ^^ E0305
"        ^^ E0304
N60 &1.5 X3
"    ^^^ E0304
N70 &-1 X4
"    ^^ E0305
N80 &5.5 X5 "the point comes before the digits"
"    ^^^ E0304
N90 &0003 X6
"    ^^^^ E0312
N100 &12345 X7
"     ^^^^^ E0312
N110 &00001202 X8
N120 F+100 X9
"     ^^^^ E0305
N130 G71 L200.
"         ^^^^ E0304
N140 G71 L200 Q+2
"              ^^ E0305
N+150 X10
"^^^^ E0305
N160. X11
"^^^^ E0304
N170 H-5 X12 R1=+5
N180 M30
N200 G79 L200
N210 G70

%196 "one code a word; a word without a value takes no part
N10 G90 G0 X--5 X6 Y5
"          ^^^^ E0106
N20 G G1 X7
"   ^ E0103
N30 G1.5 G0 X8
"    ^^^ E0304
N40 M-3 M4
"    ^^ E0305
N50 G100 G1 X9
"    ^^^ E0302
N60 R10=100000000 X10
"       ^^^^^^^^^ E0302
N70 M30

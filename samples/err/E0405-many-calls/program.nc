%405 "Chybejici makrocyklus volany vickrat
"FLW-1 once for each number, at the first call in the order of the text
N10 G90 G0 X0 Y0
N20 G72 L9405
"        ^^^^ E0405
N30 X10 G72 L9405
N40 G72 L9406 Q3
N50 G71 L100
N60 M30
N100 G79 L100
N110 G72 L9405
N120 G72 L9407
"         ^^^^ E0405
N130 G70

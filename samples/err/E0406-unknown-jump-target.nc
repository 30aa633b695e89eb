%406 "Skok do prazdna
"FLW-5 no block of that number
N10 G90 G0 X0 Y0
N20 G0 X5
N30 G73 L25 Q3
"        ^^ E0406
N40 G71 L100
N50 M30
N100 G79 L100
N110 G0 X5
N120 G73 L111
"         ^^^ E0406
N130 G70

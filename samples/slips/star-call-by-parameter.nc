%1 "hvezdicka misto N podprogramu, ktery vola parametr"
"LEX-9 PAR-3 the first call says what the star cuts off, the others say nothing
N10 G54 G90 G0 X0 Y0 Z50 R1=100
N20 G71 LR1
"       ^^^ E0404
N30 G71 LR1
N40 M30
*100 G79 L100
"@ 8:2-8:14 W0110
N110 G91 X5
N120 G90 G70

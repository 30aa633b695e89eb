%407 "Skok do jineho celku
"FLW-5 a jump stays in its unit
N10 G90 G0 X0 Y0
N20 G71 L100
N30 G73 L110 Q2
"        ^^^ E0407
N40 M30
N100 G79 L100
N110 G0 X5
N120 G73 L10
"         ^^ E0407
N130 G70

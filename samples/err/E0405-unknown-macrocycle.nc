%405 "Makrocyklus neni na disku
"FLW-1 no such file
N10 G90 G0 X0 Y0
N20 G72 L9999
"        ^^^^ E0405
N30 G72 L9998 Q2
"        ^^^^ E0405
N40 M30

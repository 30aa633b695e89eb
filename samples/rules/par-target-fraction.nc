%58 "PAR-3 a target from a parameter with a fraction
N10 R1=2.5 G90 G0 X0 Y0
N20 G71 LR1
"       ^^^ E0510
N30 M30
N100 G79 L100
N110 G70

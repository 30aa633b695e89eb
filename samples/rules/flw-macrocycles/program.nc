%108 "FLW-2 program, subprograms and macrocycles may call macrocycles
N10 G90 G0 X0 Y0
N20 G72 L9096 Q2
N30 G71 L100
N40 M30
N100 G79 L100
N110 G72 L9097
N120 G70

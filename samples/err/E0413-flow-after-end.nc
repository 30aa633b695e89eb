%413 "Volani v koncovem bloku
"PRG-2 the block with M30 cannot call
N10 G90 G0 X0 Y0
N20 G71 L100
N30 M30 G71 L100
"       ^^^ E0413
N100 G79 L100
N110 G0 X5
N120 G70

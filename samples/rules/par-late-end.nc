%61 "FLW-7 PRG-2 a call from a parameter: in the block of the end"
N10 R1=71 G90 G0 X0 Y0
N20 GR1 L100
N30 GR1 L100 M30
"   ^^^ E0413
N100 G79 L100
N110 G70

%43 "PAR-3 before execution nothing is said of a function from a parameter
N10 R1=71 R2=4 R3=25 G90 G0 X0 Y0
N20 GR1 L100 Q2 "L and Q have a use"
N30 GR2 QR3
N40 G71 L100
N50 M30
N100 G79 L100
N110 X5
N120 G70

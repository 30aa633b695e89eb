%412 "Q patri prodleve
"FLW-6 with G04 in the block Q is the dwell time
N10 G90 G0 X0 Y0
N20 G4 G71 L100 Q50
"               ^^^ W0412
N30 G73 L40 Q20 G04
"           ^^^ W0412
N40 M30
N100 G79 L100
N110 G0 X5
N120 G70

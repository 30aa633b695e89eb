%120 "GRP-6 PRG-2 a mapped cycle in a block with M30: at the N
N10 G90 G0 X0 Y0
N20 G81 X10
 N30 X20 M30
"^^^ E0413

%121 "GRP-6 PRG-2 a mapped cycle in a block with M30: at its G word
N10 G90 G0 X0 Y0
N20 X5
N30 G81 X20 M30
"   ^^^ E0413

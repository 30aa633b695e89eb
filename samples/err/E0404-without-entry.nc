%404 "Podprogram bez G79
"PRG-3 the blocks with G70 are subprogram L100 without its G79: one finding
N10 G90 G0 X0 Y0
N20 G71 L100
"        ^^^ E0404
N30 G71 L100 Q2
N40 M30
N110 G1 X10 F200
N120 X0
N130 G70

%205 "Podprogram pred koncem programu
"PRG-2 the subprogram stands before M30: one finding, and where M30 is
N10 G90 G0 X0 Y0
 N20 G71 L100
"^^^ E0205
N100 G79 L100
N110 G1 X10 F200
N120 G70
N30 G0 X0
N40 M30

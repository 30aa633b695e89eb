%62 "PRG-2 no end: the last block of the main program, G79 ends it
N10 G90 G0 X0 Y0
 N20 G71 L100
"^^^ E0205
N100 G79 L100
 N10 G0 X5
"^^^ E0204
N120 G70

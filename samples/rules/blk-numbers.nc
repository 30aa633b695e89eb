%33 "BLK-7 one number in the program and its subprograms
N10 G90 G0 X0 Y0
N20 G71 L100
 N0020 X5
"^^^^^ E0204
N30 M30
N100 G79 L100
 N10 X6
"^^^ E0204
 N30 G70
"^^^ E0204

%204 "Kopirovane bloky
"BLK-7 one number, one block, subprograms included
N10 G90 G0 X0 Y0
N20 G1 X10 F200
 N20 Y10
"^^^ E0204
 N010 X0
"^^^^ E0204
N30 G71 L100
N40 M30
N100 G79 L100
 N30 G0 X5
"^^^ E0204
N120 G70

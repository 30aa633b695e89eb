%103 "FLW-5 the block behind the last one of the unit is not of it
N10 G90 G0 X0 Y0
N20 G73 L100
"        ^^^ E0407
N30 M30
N100 G79 L100
"    ^^^ W0211
N110 G70
N120 G79 L120
"    ^^^ W0211
N130 G73 L140
"         ^^^ E0407
N135 G70
N140 G79 L140
"    ^^^ W0211
N150 G70

%104 "FLW-11 calls written with digits are followed from every unit
N10 G90 G0 X0 Y0
N20 G73 L40
N30 G72 L9998
"        ^^^^ E0405
N40 G1 X5 "the jump passes the call over"
"   ^^ W0601
N50 M30
N100 G79 L100
"    ^^^ W0211
N110 G72 L9999
"         ^^^^ E0405
N120 G0 X70000
"        ^^^^^ E0302
N130 G70

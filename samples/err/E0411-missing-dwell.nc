%411 "Prodleva bez doby
"GRP-5 G04 needs Q
N10 G90 G0 X0 Y0
N20 G4
"   ^^ E0411
N30 G04 X5 F100
"   ^^^ E0411
N40 G4 Q100
"GRP-5 a block with G04 may move: a whole X or U is not taken for a time
N41 G04 X500
"   ^^^ E0411
N42 G04 U200
"   ^^^ E0411
N43 G04 X0.5
"   ^^^ E0411
N50 M30

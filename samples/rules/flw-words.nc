%101 "FLW-7 L and Q need a use
N10 G90 G0 X0 Y0
N20 L100 Q5 X5
"   ^^^^ W0402
"        ^^ W0403
N30 G4 Q5 L1
"         ^^ W0402
N40 Q5 "the dwell of N30 holds in its own block only"
"   ^^ W0403
N50 G71 L100 Q2
N60 L100 "so does the call"
"   ^^^^ W0402
N70 M30
N100 G79 L100
N110 G0 X5
N120 G70

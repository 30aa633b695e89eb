%117 "GRP-5 Q is a whole number of 10 ms units
N10 G90 G0 X0 Y0
N20 G4 Q5.
N30 G4 Q0
N40 G04 X5 Q10 "a block with G04 may also move"
N50 G4 Q0.5
"       ^^^ E0304
N60 G4 Q10.25
"       ^^^^^ E0304
N70 G4 Q10000
"       ^^^^^ E0302
N80 G4 Q-5
"       ^^ E0305
N90 G4 X6
"   ^^ E0411
N100 M30

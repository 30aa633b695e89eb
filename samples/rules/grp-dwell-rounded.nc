%129 "GRP-5 a point is tolerated when nothing was rounded away
N10 G90 G0 X0 Y0
N20 G4 Q5.0
N30 G4 Q5.0001
"       ^^^^^^ E0304
N40 M30

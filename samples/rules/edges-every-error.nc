%700 "every error in one run"
"FLW-7 GRP-5 FLW-5 BLK-7 what cannot be followed hides no other errors
N10 G90 G0 X0 Y0 F100
N20 G2 X10 Y0 I4
"             ^^ E0603
N30 G72 L9001
"        ^^^^ E0405
N40 G1 Y5
N50 G2 X20 Y0 I5
N60 G0 X0 Y0
N70 G4
"   ^^ E0411
N80 G3 X10 Y0 I4
"             ^^ E0603
N90 G73 L5555
"        ^^^^ E0406
N100 G71
"    ^^^ E0401
N110 G0 X0 Y0
N110 G2 X10 Y0 I4
"@ 20:1-20:5 E0204
"              ^^ E0603
N120 G1 Z5
"@ 23:1-23:5 E0205

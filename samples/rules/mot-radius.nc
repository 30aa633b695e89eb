%603 "MOT-3 R without a value in a block with an arc is meant as its radius"
N10 G90 G0 X0 Y0 S800 M3
N20 G2 X10 Y0 R5.5 F100
"             ^^^^ E0106
N30 X0 R12
"      ^^^ E0103
N40 G3 X10 R-5
"          ^^^ E0106
N50 X0 Y0 CR=5
"         ^^^^ E0301
N60 G1 X5 R2.
"         ^^^ E0106
N70 M30

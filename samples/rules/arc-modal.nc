%1 "MOT-3 MOT-4 an arc by a function that is in force, in blocks without one"
N10 G90 G0 X0 Y0 Z0 F100 S500 M3
N20 G2 X10 Y0 I5
N30 X20 Y1 I5
"          ^^ E0603
N40 G1 X0 Y0
N50 G2 X10 Y0 I5
N60 X0 Y0 Z1 I-5
"   ^^ W0613
N70 K5 X10 Y0 I5
"   ^^ E0609
N80 M30

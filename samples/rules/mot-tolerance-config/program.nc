%176 "MOT-4 the tolerance of this machine
N10 G90 G0 X0 Y0 F100
N20 G2 X20.5 Y0 I10
N30 G0 X0
N40 G2 X20.6 Y0 I10
"               ^^^ E0603
N50 M30

%121 "GRP-6 an arc under a cycle that nothing maps is not known either
N10 G90 G0 X0 Y0 Z0 S100 M3 F100
N20 G81
N30 G2 X10 Y0 I5 K3
"      ^^^ W0612
N40 M30

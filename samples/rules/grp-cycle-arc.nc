%121 "GRP-7 in an arc K belongs to a helix, whatever the cycle in force
N10 G90 G0 X0 Y0 Z0 S100 M3 F100
N20 G81
N30 G2 X10 Y0 I5 K3
"                ^^ E0609
N40 M30

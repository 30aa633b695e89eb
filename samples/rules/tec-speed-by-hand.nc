%624 "no S anywhere: it was set by hand"
"TEC-8
N10 G0 X0 Y0 F100 M3
N20 G1 X50
N30 M30

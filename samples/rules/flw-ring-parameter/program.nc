%106 "FLW-2 a ring through a parameter is found by execution
N10 G90 G0 X0 Y0 R1=9094
N20 G72 L9094
N30 G1 X5
N40 M30

%263 "TEC-7 what a parameter or the cycle map calls does not count
N10 G90 G0 X0 R1=7
N20 G1 X10 F100
N30 G72 LR1
N40 X20
N50 G81 X30
N60 M30

%161 "TEC-2 TEC-3 at the first motion, whatever blocks with no motion
N10 G90 G0 X0 Z0
N20 G1
N30 X5
"   ^^ W0601
N40 G95 F0.2
N50 X10
"   ^^^ W0604
N60 X15
N70 G94 F100
N80 X20
N90 M30

%160 "TEC-7 nothing starts the spindle, so nobody misses it
N10 G90 G0 X0 Y0
N20 G1 X10 F100
N30 T5 M6
N40 M30

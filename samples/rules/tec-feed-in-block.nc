%156 "TEC-2 the feed of the block itself is in force
N10 G90 G0 X0 Y0
N20 G1 X5 F100
N30 M30

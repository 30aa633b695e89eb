%34 "BLK-7 a macrocycle file has numbers of its own
N10 G90 G0 X0 Y0
N20 G72 L9020
N30 M30

%20 "BLK-1 a block ends before the next N
N10 G90 G0 N20 X0 N30 Y0
N40
 S800

 M3
 X5
N5 Y5 G1 F100 "BLK-8 block numbers need not rise"
N3 F120 X6 G1 "BLK-1 the order of words is free"
N900 M30 *

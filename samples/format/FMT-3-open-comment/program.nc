%1
N10 G0 X1
N20  Y1 "dddddddddddddddddddddddddddddddddddddddddddddddddddddddddddddddddddddddddd
N30 M30

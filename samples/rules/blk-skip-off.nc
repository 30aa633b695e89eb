%27 "BLK-6 without block skip the block is executed
N10 G90 G0 X0 Y0
N20 / G1 X5
"     ^^ W0601
N30 M30

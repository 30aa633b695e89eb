%29 "BLK-6 block skip from the project file
N10 G90 G0 X0 Y0
N20 / G1 X5
N30 M30

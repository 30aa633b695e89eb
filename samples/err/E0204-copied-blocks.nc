%204 "Podprogram vlozeny dvakrat
"BLK-7 a run of blocks that stands in the file twice is one finding
N10 G90 G0 X0 Y0
N20 G71 L100
N30 G71 L200
N40 M30
N100 G79 L100
N110 G1 X10 F200
N120 X0
N130 G70
 N100 G79 L200
"^^^^ E0204
N110 G1 Y10 F200
N120 Y0
N130 G70

%74 "BLK-2 words before the first block of a macrocycle
N10 G90 G0 X0 Y0
N20 G72 L9084
N30 M30

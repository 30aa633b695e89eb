%203 "Priruba" G90
"              ^^^ E0203
"BLK-2 words before the first N belong to no block: one error for all of them
 G0 X0 Y0
N10 G1 X10 F200
N20 M30

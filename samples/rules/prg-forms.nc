%60 "PRG-1 the number need not match the name of the file
N10 G90 G0 X0 Y0
N20 G71 L0100
N30 G71 L200 Q2
N40 X5 M02 "PRG-2 M02 is an end as well, other words beside it are fine"
N100 G79 L100 "PRG-3 N, G79 and L, comments aside"
N110 G0 X5
N120 G70 X6 M8 "PRG-3 the block with G70 may hold other words
N200 L200 "in any order" G79
N210 G70
*

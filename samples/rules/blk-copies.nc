%28 "BLK-7 runs of blocks that stand in the file twice
N10 G90 G0 X0 Y0
N20 X10
N30 X20
 N10 X30 "two consecutive blocks, in the order of those before
"^^^ E0204
N20 X40
 N20 X50 "alone again
"^^^ E0204
 N10 X60 "the other way round: two findings
"^^^ E0204
 N30 X70
"^^^ E0204
 N30 X80
"^^^ E0204
N40 M30

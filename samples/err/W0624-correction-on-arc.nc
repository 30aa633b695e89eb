%629 "the correction begins on an arc"
"TEC-9 in the block, and as the first motion after it
N10 G0 X0 Y0 F100 D1
N20 G41 G2 X20 Y0 I10
"       ^^ W0624
N30 G1 X30
N40 G40
N50 G3 X40 Y10 J10
"   ^^ W0624
N60 G1 X50
N70 G42 Y20
N80 G41 Y30
"   ^^^ W0624
N90 G40 Y40
N100 M30

%630 "G92 and G93 without words"
"GRP-4 they write the values of the axis words in their block
N10 G54 G90 G00 X0 Y0
N20 G92
"   ^^^ W0630
N30 G92 G55 D5
"   ^^^ W0630
N40 G93
"   ^^^ W0630
N50 G92 G55 X10
N60 G93 X0
N70 G92 D5 Z12.5
N80 M30

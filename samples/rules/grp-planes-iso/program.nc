%85 "GRP-2 a mill without a 4th axis
N10 G90 G0 X50 Y0 Z2 G17
N20 G18
N30 G19
N40 G15
"   ^^^ W0616
N50 G16
"   ^^^ W0616
N60 M30

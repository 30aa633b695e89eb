%625 "a thread needs a feed too"
"TEC-8 W0601 with G33
N10 G95 S500 M3
N20 G0 X0 Z5
N30 G33 Z-20
"   ^^^ W0601
N40 M30

%178 "MOT-7 the axes of G30 are unknown after it
N10 G90 G0 X0 Y0 Z0
N20 G30 X0 Z0
N30 G91
N40 X5
"   ^^ W0605
N50 Y5
N60 Z5
"   ^^ W0605
N70 M30

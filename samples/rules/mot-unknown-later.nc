%162 "MOT-2 from an unknown position, in blocks of axis words only
N10 G0 G91
N20 X5
"   ^^ W0605
N30 X5 "once for an axis"
N40 Y5 X5
"   ^^ W0605
N50 G90 X0 Y0 Z0
N60 M30

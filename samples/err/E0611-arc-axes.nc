%611 "Osy oblouku
"MOT-3 the words must name the plane
N10 G90 G0 X0 Y0 Z0 C0
N20 G17 G1 X5 Y5 F200
N30 G2 Z10 I5
"   ^^ E0611
N40 G3 X5 Z0 C5 I5
"   ^^ E0611
N50 M30

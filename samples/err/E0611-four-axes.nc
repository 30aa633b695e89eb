%6111 "Ctyri osy v oblouku
"MOT-3 at most three axis words
N10 G90 G0 X0 Y0 Z0 C0
N20 G17 G1 X5 Y5 F200
N30 G2 X25 Y5 Z-5 C90 I10
"   ^^ E0611
N40 M30

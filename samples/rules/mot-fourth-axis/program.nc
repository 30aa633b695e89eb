%173 "MOT-3 MOT-5 planes with the 4th axis
N10 G90 G0 X0 Y0 Z0 U0 F100
N20 G14
N30 G2 Z10 I5 "Z and U: I along Z"
N40 U10 J5
N50 G15
N60 G3 Y10 I5
N70 G16
N80 G3 X10 I5 "U and X: X is the earlier axis, I along X"
N90 U20 J5
N100 G2 Y20 I5
"    ^^ E0611
N110 M30

%192 "everything configured
N10 G90 G0 XR10 Y0 C0 Z5 S100 M3
N20
N30 L5 Q5
"   ^^ W0402
"      ^^ W0403
N40 / G1 X5
N50 X0 "this line is too long, and the configuration allows it xxxxxxxxxxxxxxxxxxxxxxxxxxx
N60 G2 Y20 X0 I10 F100 "I along Y: it is the earlier axis"
N70 G2 X20 J10
N80 M41 S500 M3 M91
N90 M30

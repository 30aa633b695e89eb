%102 "GRP-2 an arc beside the plane of the radius correction
N10 G90 G0 X0 Y0 Z0 F100 D1
N20 G2 X20 Z0 I10 "no correction
N30 G41 G1 X0
N40 G2 X20 Z0 I10
"   ^^ W0616
N50 G19 G3 X0 I-10
N60 G40 G0 X50
N70 M30

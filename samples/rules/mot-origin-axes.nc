%635 "a change of origin, each axis for itself"
"MOT-8 the arc in N50 begins where Y has not moved since
N10 G54 G90 G0 X0 Y0 F100
N20 G55
N30 G0 X10
N40 G0 Z5
N50 G2 X20 Y0 I5
"   ^^ W0610
N60 G3 X30 Y0 I5
N70 M30

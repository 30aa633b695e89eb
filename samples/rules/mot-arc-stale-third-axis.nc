%201 "MOT-8: an arc with a third axis, from a point whose origin changed
N10 G90 G00 X0 Y0 Z0 F100
N20 G54
N30 G02 X10 Y0 I5 Z3
"   ^^^ W0613
"@ 4:5-4:8 W0610
N40 M30

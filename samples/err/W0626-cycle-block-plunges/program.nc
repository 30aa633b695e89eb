%633 "the depth in the block of a mapped cycle"
"TEC-10 the axis perpendicular to the plane, while G00 is in force
N10 G0 X0 Y0 Z5 F100
N20 G81 X10 Y10 Z-18.5
"               ^^^^^^ W0626
N30 X20
N40 G1 X30 Z-5
N45 G0 G18 Y5 Z3
N50 G19 Z10 Y2
"           ^^ W0626
N60 G80 G17
N70 M30

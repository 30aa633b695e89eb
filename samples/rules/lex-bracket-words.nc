%1 "what the words of a (comment) would have set is not known"
N1 G90 G17 G0 X0 Y0 Z0 F100 S100 M3
N2 G1 X1 (tool X10)
"        ^^^^^^^^^^ E0101
N3 G2 X20 Y0 I5
N4 G0 X0 Y0
N5 G1 X1 ; hloubka X10
"        ^^^^^^^^^^^^^ E0101
N6 G2 X20 Y0 I5
N7 G0 X0 Y0
N8 G1 X1 (prejezd)
"        ^^^^^^^^^ E0101
N9 G2 X20 Y0 I5
"            ^^ E0603
N10 M30

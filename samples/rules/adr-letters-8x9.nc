"! dialect=cnc8x9
%7 "ADR-4 beside X, Y, Z three letters, one of them A, B or C"
N10 G90 G0 U0 V0 X0
N20 W5 Y0
"   ^^ E0311
N30 A1 Z0
"   ^^ E0311
N40 M30

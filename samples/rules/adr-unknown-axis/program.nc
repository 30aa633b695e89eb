%6 "ADR-4 a lathe has X and Z
N10 G90 G0 X0 Z0
N20 Y5 X5
"   ^^ E0311
N30 C-99999 X6 "the axis comes before the range"
"   ^^^^^^^ E0311
N40 U1.2345 X7
"   ^^^^^^^ E0311
N50 G2 X9 Z0 I1 J0 F200 "I and J are no axes"
N60 G2 B10 Z-8 I5 J-4 "which axis was meant is open"
"      ^^^ E0311
N70 M30

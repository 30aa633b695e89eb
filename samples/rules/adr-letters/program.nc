"! dialect=cnc8x6
%6 "ADR-4 three beside X, Y, Z by the text, program before macrocycles
N10 G90 G0 A0 B0
N20 G72 L9006
N30 X0 Y0
N40 Z0 U0
N50 M30

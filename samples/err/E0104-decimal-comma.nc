%104 "Desetinna carka
"LEX-12 the decimal point is a point
N10 G90 G0 X0 Y0 S800 M3
N20 G1 X36,12 F120,5
"      ^^^^^^ E0104
"             ^^^^^^ E0104
N30 Y-0,5 X40.5
"   ^^^^^ E0104
N40 R10=2,5
"   ^^^^^^^ E0104
N50 G2 X50.5 Y-0.5 I5,0 J0
"                  ^^^^ E0104
N60 M30

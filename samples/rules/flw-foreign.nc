%404 "FLW-7, GRP-5 calls, jumps and dwells as other controls write them"
"! args=-A other-control
N10 G90 G0 X0 Y0
N20 G73 N10 Q3
"   ^^^ E0401
N30 G71 N100
"   ^^^ E0401
N40 G71 U2 R1
"   ^^^ E0401
N50 G71 P150 Q200 U0.5 W0.1 F0.2
"   ^^^ E0401
N60 G70 P150 Q200
"   ^^^ E0212
N70 G73 X5 Y5 Z-10 R2. Q5 F100
"   ^^^ E0401
N80 G04 P500
"   ^^^ E0411
N90 G04 X0.5
"   ^^^ E0411
N100 G04 F1.5 M8
"    ^^^ E0411
N110 G04 P5
"    ^^^ E0411
N120 G10 L2 P1 X0 Y0 Z0
"        ^^ W0402
N130 M98 P10 L4
"            ^^ W0402
N140 G71 G90 G17
"    ^^^ E0401
N150 G73 N10 X5
"    ^^^ E0401
"        ^^^ E0204
N160 G54.1 P1 G05.1
"     ^^^^ E0304
"              ^^^^ E0304
N900 M30

"! args=--max-blocks=20
%411 "Volani, ktera se nasobi
"FLW-9 the calls that multiply are named, others are not
N10 G90 G0 X0 Y0
N20 G71 L100 Q50
N30 M30
N100 G79 L100
N110 G71 L200
"    ^^^ W0414
N120 G70
N200 G79 L200
N210 G71 L300 Q3
"@ 12:1-12:5 E0410
N220 G70
N300 G79 L300
N310 G0 X5
N320 G70

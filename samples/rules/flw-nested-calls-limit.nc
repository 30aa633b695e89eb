"! args=--max-blocks=26
%91 "FLW-9 nested repeats multiply; FLW-2 warns once
N10 G90 G0 X0 Y0
N20 G71 L100 Q2
 N30 M30
"^^^ E0410
N100 G79 L100
N110 G71 L200 Q3
"    ^^^ W0414
N120 G70
N200 G79 L200
N210 X5
N220 G70

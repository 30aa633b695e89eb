"! args=--max-blocks=18
%86 "FLW-4 a counter for each execution of the unit
N10 G90 G0 X0 Y0
N20 G71 L100 Q2
 N30 M30
"^^^ E0410
N100 G79 L100
N110 X5
N120 G73 L110 Q2
N130 G70

"! args=--max-blocks=6
%89 "FLW-6 the call is made once
N10 G90 G0 X0 Y0
N20 G71 L100 Q50 G4
"            ^^^ W0412
N30 M30
N100 G79 L100
N110 X5
N120 G70

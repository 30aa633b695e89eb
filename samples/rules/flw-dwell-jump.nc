"! args=--max-blocks=4
%87 "FLW-6 Q is the dwell, the jump is taken once
N10 G90 G0 X0 Y0
N20 G4 G73 L20 Q50
"              ^^^ W0412
N30 M30

"! args=--max-blocks=9
%88 "FLW-6 with G04 a forward jump is counted, k is 1
N10 G90 G0 X0 Y0
N20 G4 G73 L40 Q50
"              ^^^ W0412
N30 X5
N40 G73 L20 Q2
N50 M30

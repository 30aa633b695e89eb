"! args=--max-blocks=7
%85 "FLW-3 a jump to the own block is backward
N10 G90 G0 X0 Y0
N20 G73 L20 Q2 "three times"
N30 G73 L30 "twice"
N40 M30

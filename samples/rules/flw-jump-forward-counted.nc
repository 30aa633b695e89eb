"! args=--max-blocks=9
%83 "FLW-4 taken, not taken and disarmed, taken: nine records
N10 G90 G0 X0 Y0
N20 G73 L40 Q1
N30 X5
N40 G73 L20 Q2
N50 M30

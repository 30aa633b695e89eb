"! args=--max-blocks=10
%93 "FLW-4 L is read at every arrival
N10 R1=20 G90 G0 X0 Y0
N15 G73 L30
N20 R1=30
N30 X5
N40 G73 LR1 Q2
N50 M30

"! args=--max-blocks=10
%92 "FLW-4 Q is read when the counter is armed
N10 R1=2 G90 G0 X0 Y0
N20 G73 L40
N30 R1=9
N40 X5
N50 G73 L30 QR1
 N60 M30
"^^^ E0410

%105 "FLW-4 Q is read when the counter is loaded: later it may be no count
N10 G90 G0 X0 Y0 R1=2 R2=0.5
N20 X5
N30 G73 L20 QR1 R1=R2
"           ^^^ W0504
"           ^^^ E0510
N40 G1 X6
"   ^^ W0601
N50 M30

%104 "FLW-3 a jump whose count is no count is not taken
N10 G90 G0 X0 Y0 R1=0.5
N20 X5
N30 G73 L20 QR1
"           ^^^ E0510
N40 G1 X6
"   ^^ W0601
N50 M30

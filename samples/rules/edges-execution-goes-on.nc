%195 "execution goes on after its errors; once for a block executed often
N10 G90 G0 X0 Y0
N20 G71 L100 Q3
N30 R1=2.5
N40 SR1 X5
"   ^^^ E0510
N50 G1 X10
"   ^^ W0619
"   ^^ W0601
N60 M30
N100 G79 L100
N110 G90 G0 X0 Y0
N120 R2=-5
N130 TR2
"    ^^^ E0510
N140 G70

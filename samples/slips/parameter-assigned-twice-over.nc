%1 "dva parametry jednim prirazenim"
N10 G54 G90 G0 X0 Y0 Z50
N20 R1 = R2 = 5
"   ^^^^^^^^^^^ E0106
N30 XR1 YR2
N40 R3=R4=5
"   ^^^^^^^ E0106
N50 M30

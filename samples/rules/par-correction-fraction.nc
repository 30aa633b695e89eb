%65 "PAR-3 digits of a correction from a parameter
N10 R1=0.5 R2=12 R3=13 G90 G0 X0 Y0
N20 &R2
N30 &R1
"   ^^^ E0510
N40 &R3
"   ^^^ E0510
N50 M30

%42 "PAR-3 a value from a parameter obeys the same rules
N10 R1=1 R2=4 R3=20 R4=0.5 R5=1234 R6=60
N20 G90 G0 X0 Y0 S800 F100
N30 G0 GR1 X5
"      ^^^ E0307
N40 M3 MR2
"      ^^^ E0308
N50 GR3 X6
"   ^^^ E0309
N60 G4 QR4
"      ^^^ E0510
N70 &R5
"   ^^^ E0510
N80 T1 M6 MR6
"         ^^^ E0308
N90 M30

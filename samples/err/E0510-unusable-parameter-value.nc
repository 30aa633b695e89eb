%510 "Parametr se nehodi
"PAR-3 a value from a parameter obeys the same rules
N10 R1=2.5 R2=80000000 R3=-5 R4=101 R5=10000
N20 G90 G0 X0 Y0
N30 SR1 M3
"   ^^^ E0510
N40 XR2
"   ^^^ E0510
N50 TR3 M6
"   ^^^ E0510
N60 MR4
"   ^^^ E0510
N70 DR5
"   ^^^ E0510
N80 GR1 Y5
"   ^^^ E0510
N90 G0 Y10
N100 M30

%196 "parameters that a fault leaves unknown
N10 R1=1 R2=2 R3=3 R4=4
N20 R1=100000.5 R2=5 R2=6
"      ^^^^^^^^ E0302
"                    ^^^^ E0306
N30 G90 G1 XR1 YR2 F200 "both are unknown, and nothing is said
N40 G91 X1 Y1
N50 R=5 "any parameter
"   ^^^ E0106
N60 G90 G1 XR3 YR4
N70 G91 X1 Y1
N80 R3=3 R4=4
N90 G90 XR3 YR4
N100 G26 "any parameter
"    ^^^ E0505
N110 G91 X1 Y1 G71 LR3 "what is called is unknown, and so is all that follows
N120 G2 X5
N130 M30

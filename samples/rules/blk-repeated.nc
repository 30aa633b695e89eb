%23 "BLK-3 each address at most once
N10 G90 G0 X1 X1 Y1 Y2 Z1 Z2
"             ^^ E0306
"                   ^^ E0306
"                         ^^ E0306
N20 A1 A2 B1 B2 C1 C2
"      ^^ E0306
"            ^^ E0306
"                  ^^ E0306
N30 U1 U2 V1 V2 W1 W2
"      ^^ E0306
"            ^^ E0306
"                  ^^ E0306
N40 G2 X5 I1 I2 J1 J2 F100
"   ^^ W0619
"            ^^ E0306
"                  ^^ E0306
N50 F100 F100 S800 S0800 G1
"        ^^^^ E0306
"                  ^^^^^ E0306
N60 T1 T2 D1 D2 H1 H2 P1 P2
"      ^^ E0306
"            ^^ E0306
"                  ^^ E0306
"                        ^^ E0306
N70 &1 &2 X5
"      ^^ E0306
N80 R1=1 R2=2 R01=3 R3=3
"             ^^^^^ E0306
N90 XR1 X5
"       ^^ E0306
N100 / X5 / Y5
"         ^ E0306
N110 G71 L200 Q2 Q3
"                ^^ E0306
N120 G1 G01 X5 "the same G twice is a conflict of its group"
"       ^^^ E0307
N130 M8 M08 X6
"       ^^^ E0308
N140 G0 G90 G17 M3 M8 M41 "one of each group is fine"
N150 M30
N200 G79 L200
N210 G70

%311 "Osa, kterou stroj nema
"ADR-4 this machine has X Y Z C
N10 G90 G0 X0 Y0 Z50 C0
N20 A90 X5
"   ^^^ E0311
N30 W-5.5 Y5
"   ^^^^^ E0311
N40 C45 U99999
"       ^^^^^^ E0311
N50 M30

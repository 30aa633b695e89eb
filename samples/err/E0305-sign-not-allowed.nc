%305 "Znamenko, kde nema byt
"ADR-1 a written plus is a sign too
N10 G90 G+0 X+5 Y-5
"        ^^ E0305
N20 S-800 M3
"    ^^^^ E0305
N30 G1 X10 F-100
"           ^^^^ E0305
N40 T+2 M-6
"    ^^ E0305
"        ^^ E0305
N50 G4 Q-50
"       ^^^ E0305
N-60 G0 Z100
"^^^ E0305
N70 M30

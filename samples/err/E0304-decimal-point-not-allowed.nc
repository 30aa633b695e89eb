%304 "Tecka, kde nema byt
"ADR-1 only dimensional words may carry a decimal point
N10 G90 G0.0 X0 Y0
"        ^^^ E0304
N20 S800.5 M3.
"    ^^^^^ E0304
"           ^^ E0304
N30 T1. M6 D1.0
"    ^^ E0304
"           ^^^ E0304
N35.5 G0 X5
"^^^^ E0304
N40 G4 Q0.5
"       ^^^ E0304
N50 G71 L100 Q2.
"             ^^ E0304
N60 M30
N100 G79 L100
N110 G0 X5
N120 G70

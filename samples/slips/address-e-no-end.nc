%1 "E neni adresa, a konec chybi
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3 F250
N40 G1 X5 E5
"         ^^ E0301
"@ 5:1-5:4 E0205

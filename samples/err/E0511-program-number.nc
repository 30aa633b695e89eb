 %R1 "Cislo programu z parametru
"^^^ E0511
N10 G90 G0 X0 Y0
N20 M30

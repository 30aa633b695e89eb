%511 "Cislo bloku z parametru
"PAR-2 never for N
N10 R1=25 G90 G0 X0 Y0
 NR1 G0 X5
"^^^ E0511
N30 M30

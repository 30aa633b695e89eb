%1 "prvni radek bez cisla
G54 G90 G0 X0 Y0
N20 G1 Z-2 F300
N30 X50
N40 M30
"@ 2:1-2:4 E0203

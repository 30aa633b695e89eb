%1 "zadny blok nema cislo
G54 G90 G0 X0 Y0
S1200 M3
G1 Z-2 F300
X50
Y50
M30
"@ 2:1-2:4 E0203

%1 "znamenko mezi mezerami, bez rovnitka"
N10 G54 G90 G0 X0 Y0 Z50
N50 R29 - 12
"   ^^^^^^^^ E0102
N80 G0 Z50
N90 M30

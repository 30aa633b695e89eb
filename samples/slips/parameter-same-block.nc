%1 "prirazeni a cteni v jednom bloku
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N35 R10=40
N40 R10=50 G1 XR10 F300
"             ^^^^ W0504
N60 M30

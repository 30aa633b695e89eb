%1 "carka misto tecky, pismeno navic"
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 G1 Z-2 F300
N50 G1 Xl10,5
"      ^^^^^^ E0104
N80 G0 Z50
N90 M30

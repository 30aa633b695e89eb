%1 "radek zlomeny uprostred cisla"
N10 G54 G90 G0 X0 Y0 Z50
N20 G71 L100
N30 M30
N100 G79 L100
N110 G1 X5 F200 S500 M3 G7
0 "konec podprogramu G70"
"@ 7:1-7:2 E0106

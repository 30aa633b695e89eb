%64 "FLW-5 PAR-3 a jump by parameter stays in its unit too
N10 R1=100 G90 G0 X0 Y0
N20 G73 LR1
"       ^^^ E0407
N30 M30
N100 G79 L100
"    ^^^ W0211
N110 G70

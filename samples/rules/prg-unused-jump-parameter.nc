%75 "PRG-4 a jump by parameter calls no subprogram
N10 G90 G0 X0 Y0 R1=30
N20 G73 LR1
N30 M30
N100 G79 L100
"    ^^^ W0211
N110 G70

%65 "PRG-4 named by a G71 anywhere in the file is enough
N10 G90 G0 X0 Y0
N20 G73 L40
N30 G71 L300 "never reached, named all the same"
N40 M30
N100 G79 L100
"    ^^^ W0211
N110 G71 L200
"    ^^^ W0414
N120 G70
N200 G79 L200
N210 G70
N300 G79 L300
N310 G70

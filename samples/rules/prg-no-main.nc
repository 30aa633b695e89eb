 %63 "PRG-2 a main program without a block
"^^^ E0205
N100 G79 L100
"    ^^^ W0211
N110 G0 X5
N120 G70

%5102 "Cislo podprogramu z parametru
"BLK-10 G79 with its L is written out
N10 R1=100
N20 G71 LR1
N30 M30
N100 G79 LR1
"        ^^^ E0510
N110 G0 X5
N120 G70

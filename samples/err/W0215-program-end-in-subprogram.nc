%215 "Konec programu v podprogramu
"PRG-5 M30 there ends the whole program
N10 G90 G0 X0 Y0
N20 G71 L100
N30 M30
N100 G79 L100
N110 G0 X5
N120 M30
"    ^^^ W0215
N130 G70

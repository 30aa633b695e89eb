%68 "PRG-5 G70 in the main program
N10 G90 G0 X0 Y0
N20 X5 G70
"      ^^^ E0212
N30 M30

%212 "G70 v hlavnim programu
"PRG-5 the main program ends with M02 or M30
N10 G90 G0 X0 Y0
N20 G1 X10 F200
N30 G70 Y5
"   ^^^ E0212
N40 M30

%99 "PAR-3 FLW-5 a target from a parameter: at the word
N10 R1=25 G90 G0 X0 Y0
N20 G73 LR1
"       ^^^ E0406
N30 G1 X5 "the jump is not taken"
"   ^^ W0601
N40 M30

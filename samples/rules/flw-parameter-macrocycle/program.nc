%105 "FLW-11 a macrocycle that execution finds is checked as a whole
N10 R1=9085 G90 G0 X0 Y0
N20 G72 LR1
N25 G1 X7
"   ^^ W0601
N30 M30

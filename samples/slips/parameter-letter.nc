%1 "jine pismeno nez R"
N10 G54 G90 G0 X0 Y0 Z50
N20 R10=4 R11=2 R12=0
N30 G26 P5=01101112
"       ^^^^^^^^^^^ E0106
N40 M30

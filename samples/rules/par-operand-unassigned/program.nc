%57 "PAR-5 an operand is a read
N10 R10=5 G90 G0 X0 Y0
N20 G26 R5=01102122
"          ^^^^^^^^ W0503
N30 XR21
N40 XR22 "depends on it: nothing more is said"
N50 M30

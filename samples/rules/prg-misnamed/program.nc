%513 "a program called as a macrocycle"
"PRG-6 one finding, at its first block; positions are unknown after it
N10 G0 G90 X0 Y0 F100
N20 G72 L13
N30 G2 X10 Y0 I5 J0
N40 M30

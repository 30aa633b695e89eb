%69 "PRG-5 M30 in a macrocycle ends the whole program
N10 G90 G0 X0 Y0
N20 G72 L9061
N30 G1 X5 "never executed: no feed is missed"
N40 M30

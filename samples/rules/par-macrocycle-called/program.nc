%53 "PAR-6 one set for all; PAR-5 read first in the macrocycle
N10 R1=5 G90 G0 X0 Y0
N20 G72 L9031
N30 XR3 YR2
N40 M30

%72 "PRG-7 a leading percent line is tolerated
N10 G90 G0 X0 Y0
N20 G72 L9081
N30 M30

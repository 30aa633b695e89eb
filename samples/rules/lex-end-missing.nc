%1019 "LEX-9 it may be left out
N10 G90 G0 X0 Y0
N20 M30
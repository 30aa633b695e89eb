%60 "PAR-3 FLW-7 a call whose function comes from a parameter
N10 R1=72 G90 G0 X0 Y0
N20 GR1 L77
"        ^^ E0405
N30 M30

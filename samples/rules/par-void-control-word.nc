%63 "PAR-7 a control word without a value is written, though
N10 G90 G0 X0 Y0
N20 G26 R5
"       ^^ E0103
N30 M30

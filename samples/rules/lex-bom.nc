%1014 "LEX-8 a byte-order mark is ignored
N10 G90 G0 X0 Y0
N20 M30

%1016 "LEX-8 also in an open comment
N10 G90 G0 X0 Y0
N20 M30 "konec 

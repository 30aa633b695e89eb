%606 "Oblouk odnikud
"MOT-4 the start is unknown in Y
N10 G90 G0 X0
N20 G2 X20 Y0 I10 F200
"   ^^ W0606
N30 G2 X40 Y0 I10
N40 M30

%1 "pismeno N navic: blok, ktery nikdo nechtel"
N10 G54 G90 G0 X0 Y0 Z50
N20 X5
N40 X7 N20
"      ^^^ E0204
N60 M30

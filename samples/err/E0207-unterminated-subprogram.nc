%207 "Podprogram bez G70
"PRG-3 a subprogram ends with G70
N10 G90 G0 X0 Y0
N20 G71 L100
N30 G71 L200
N40 M30
N100 G79 L100 "G70 zapomenuto, zacina dalsi podprogram
"    ^^^ E0207
N110 G0 X5
N200 G79 L200
"    ^^^ E0207
N210 G0 Y5
N220 X0

%208 "Zacatky podprogramu
"PRG-3 a subprogram begins with its number, G79 and L
N10 G90 G0 X0 Y0
N20 G71 L100
N30 G71 L200
N40 G71 L300
N50 G71 L400
N60 M30
N100 G79 L100 G90 X0
"             ^^^ E0208
N110 G70
N200 / G79 L200
"    ^ E0208
N210 G70
N300 X5 G79 L300 Y2
"    ^^ E0208
N310 G70
N400 L400 G79 "poznamka smi byt"
N410 G70

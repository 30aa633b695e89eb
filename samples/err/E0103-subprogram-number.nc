%103 "Cislo podprogramu chybi
"PRG-3 FLW-1 calls of a subprogram whose number is lost are no mistakes
N10 G90 G0 X0 Y0 G71 L300
N20 X5 G71 L300
N30 M30
N40 G79 L
"       ^ E0103
N50 G0 Z5 G70

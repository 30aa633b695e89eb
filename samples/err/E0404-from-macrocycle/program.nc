%4041 "Makrocyklus vola podprogram
"PRG-4 a macrocycle cannot call a subprogram, not even one of this program
N10 G90 G0 X0 Y0
N20 G71 L100
N30 G72 L9001
N40 G71 L9001 "to je makrocyklus
"        ^^^^ E0404
N50 M30
N100 G79 L100
N110 G0 X5
N120 G70

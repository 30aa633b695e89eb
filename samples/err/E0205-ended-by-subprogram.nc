%2051 "Podprogram bez konce hlavniho programu
"PRG-2 subprograms after it are still read
N10 G90 G0 X0 Y0
 N20 G71 L100
"^^^ E0205
N100 G79 L100
N110 G0 X70000
"        ^^^^^ E0302
N120 G70

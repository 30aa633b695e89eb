%408 "Podprogram vola sam sebe
"FLW-2 a ring of one: W0414 does not come beside it
N10 G90 G0 X0 Y0
N20 G71 L100
N30 M30
N100 G79 L100
N110 G71 L100
"        ^^^^ E0408
N120 G70

%404 "Preklep v cisle podprogramu
"FLW-1 there is no such subprogram in this file
N10 G90 G0 X0 Y0
N20 G71 L1000
"        ^^^^ E0404
N30 G71 L100 Q2
N40 G71 L101 Q3
"        ^^^ E0404
N50 M30
N100 G79 L100
N110 G0 X5
N120 G70

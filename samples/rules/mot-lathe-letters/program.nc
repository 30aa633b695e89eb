%1 "stred slovem K, osa Z je pred X"
"MOT-3 I belongs to the earlier axis of the machine, here Z, and J to X
N10 G90 G94 G0 X30 Z0 M03 S500
N20 G3 X35 Z-5 I0 K-5 F100
"                 ^^^ E0609
N30 G2 X40 Z-10 K0 I5
"               ^^ E0609
N40 M30

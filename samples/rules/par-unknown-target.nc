%46 "PAR-5 an unknown target ends the flattening
N10 G90 G0 X0 Y0
N20 G71 LR40
"       ^^^^ W0503
N30 G1 X5 "never executed: the feed is not missed
N40 M30
N100 G79 L100
N110 G1 X5
N120 G70

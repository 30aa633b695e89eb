%97 "FLW-10 modal state and positions go into calls and out of them
N10 G71 L100
N20 X50 "G1 and F from the subprogram"
N30 G91
N40 X5 Y5 "positions too"
N50 M30
N100 G79 L100
N110 G90 G0 X0 Y0
N120 G1 F200
N130 G70

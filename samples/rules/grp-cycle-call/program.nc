%119 "GRP-6 a block that would call both a cycle and a subprogram
N10 G90 G0 X0 Y0
N20 G81 X10
N30 X20 G71 L100
"       ^^^ E0307
N40 G71 L100 "no motion, no cycle"
N50 G80
N60 X30 G71 L100
N70 M30
N100 G79 L100
N110 M8
N120 G70

"! args=--block-skip
%31 "BLK-10 the same for G70
N10 G90 G0 X0 Y0
N20 G71 L100
N30 M30
N100 G79 L100
"    ^^^ E0207
N110 G0 X5
N120 / G70
"    ^ W0219

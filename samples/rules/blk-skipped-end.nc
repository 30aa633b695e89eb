"! args=--block-skip
%30 "BLK-10 running past a skipped end is the error of a missing end
N10 G90 G0 X0 Y0
N20 G0 X5
 N30 / M30
"^^^ E0205
"    ^ W0219

"! args=--block-skip
%65 "PRG-2 BLK-10 only a skippable end: it counts, running past it is E0205
N10 G90 G0 X0 Y0
N20 / M30
"   ^ W0219
 N30 X10
"^^^ E0205

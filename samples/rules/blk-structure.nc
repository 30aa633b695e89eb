%32 "BLK-10 the block is an end whether or not it is skippable
N10 G90 G0 X0 Y0
N20 G71 L100
N25 G71 L200
N30 / M02
"   ^ W0219
N40 G0 X5 "PRG-2 after a skippable end the main program goes on, up to G79
N100 G79 L100
N110 G0 X5
N120 G70 /
"        ^ W0219
N200 / G79 L200 "with G79 it is E0208 instead"
"    ^ E0208
N220 G70

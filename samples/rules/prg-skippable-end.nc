%64 "PRG-2 the program goes on after a skippable end, up to one without /
N10 G90 G0 X0 Y0
N20 / M30
"   ^ W0219
N30 X10 G73 L10 Q1
N40 M30
 N50 X20
"^^^ E0206

%116 "Slova jinych systemu"
"§13 legal words that are written for what they mean elsewhere"
N10 G90 G0 X0 Y0
N20 G92 S2000
"       ^^^^^ W0116
N30 M98 P10
"   ^^^ W0116
N40 G92 S2000 D1 X5
N50 M98
N60 T0101
"   ^^^^^ W0116
N70 M06
N80 G73 L60 P5
"           ^^ W0116
N90 G73 L80 P5 Q2
N100 P5
N110 M30

%119 "Slova jinych systemu v blocich, ktere se neprovadeji"
"! dialect=cnc8x9
"§13, GRP-4, GRP-7 blocks that nothing executes are checked; T0101 with M06
N10 G54 G90 G17 T0101 M06
"               ^^^^^ W0116
N20 S1000 M03
N30 G00 X0 Y0 Z5
N40 T0303
"   ^^^^^ W0116
N50 M06
N60 M30
N100 G79 L5
"    ^^^ W0211
N110 G97 S1500
"        ^^^^^ W0116
N120 G73 L110 P5
"             ^^ W0116
N130 G92
"    ^^^ W0630
N140 G93 G54
"    ^^^ W0630
N150 G93 X5
N160 G73 L110 P5 Q2
N155 G92 X5 I3
"           ^^ E0609
N157 G23 G01 X5 I7
"                ^ E0302
N158 G23 I2.5
"         ^^^ E0302
N159 G23 X5 I7
N170 T0202
"    ^^^^^ W0116
N172 G73 L110 P100
"              ^^^ E0302
N174 G97 S10000
"         ^^^^^ E0302
N176 G92 X5 I99999
"            ^^^^^ E0302
N180 G70

%609 "Slova I J K bez pouziti
"MOT-3 K in an arc; GRP-7 I needs G23; GRP-8 G33 takes what it is given
N10 G90 G0 X0 Y0 Z0 S100 M3
N20 G2 X20 Y0 I10 K5 F200
"                 ^^ E0609
N30 G1 X30 I5
"          ^^ E0609
N40 G0 Y0 J2 K-3
"         ^^ E0609
N50 G33 Z-20 K1.5
N60 M30

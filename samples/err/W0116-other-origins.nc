%117 "G53 pro jeden blok, otacky pri G97"
"! dialect=cnc8x9
"§13 G53 holds until another zero offset here; S under G97 is a cutting speed"
N10 G54 G90 G17 T1 M06
N20 S1000 M03
N30 G00 X0 Y0 Z5
N40 G01 Z-2 F200
N50 G53 Z100
N60 G00 X50
N70 G01 Z-2
"   ^^^ W0116
N80 X60
"said once for each G53
N85 G54
N90 G53 G00 Z100
N100 G01 X70
"    ^^^ W0116
"right: a place to change the tool, an origin for work with other axes
N110 G54 G00 Z100
N120 G53 Z200
N130 X300 Y300
N140 T2 M06
N150 G55 G00 X0 Y0
N160 G01 X5
N170 G53 G00 X0 Y0
N180 G01 X5
N190 G53 Z5
N200 G01 Z0
N210 G97 S180 F0.2
N220 X6
N230 G97 S1800
"        ^^^^^ W0116
N240 X7
N250 G97 S900
N260 G94 S3000
N270 M30

%306 "Opakovane adresy
"BLK-3 each address once in a block
N10 G90 G0 X0 Y0 X10
"                ^^^ E0306
N20 G1 X10 F100 F200
"   ^^ W0619
"               ^^^^ E0306
N30 R10=1 R11=2 R10=3
"               ^^^^^ E0306
N40 / G0 X5 / Y5
"           ^ E0306
N50 S800 M3 S900
"           ^^^^ E0306
N60 G71 L100 L100
"            ^^^^ E0306
N70 M30
N100 G79 L100
N110 G0 Z5
 Z10
"^^^ E0306
N120 G70

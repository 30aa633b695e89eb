%195 "what is unknown after a fault gives no finding
N10 G90 G0 X0 Y0 Z50 F200 S800
N20 G1 X4O Y,5 "a fix gives these their values
"   ^^ W0619
"      ^^^ E0107
"          ^^^ E0104
N30 X "X is unknown: the arc is not judged
"   ^ E0103
N40 G2 X20 Y0 I10 J0
N50 G1 X0 Y0
N60 G2 X99999 Y0 I10 J0
"       ^^^^^ E0302
N70 G1 X0 Y0
N80 G2 X20 Y0 I1.2.3 J0
"             ^^^^^^ E0106
N90 G1 X0 Y0
N100 G2 X20 Y0 I10 I11 J3
"                  ^^^ E0306
N110 G1 X0 Y0 F99999999
"              ^^^^^^^^ E0302
N120 G95 X1 S99999 "of the feed nothing is known, nor of the speed
"            ^^^^^ E0302
N130 G94 G2 X20 Y5 "known again
"        ^^ E0602
N140 G33 G1 X0 "of the group nothing is known until it is written again
"        ^^ E0307
N150 X1 I3
N160 G91 X-1
N170 G90 G0 X0 Y0
N180 G2 X20 Y0 I9 J0
"              ^^ E0603
N190 G20 X5 "no function, which moves nothing
"     ^^ E0309
N200 G1 G91 X5
N210 G90 X0 Y0
N220 G-1 Y5 "any function
"     ^^ E0305
N230 G91 X5 G2 Y0 K3
N240 M30

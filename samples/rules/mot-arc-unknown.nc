%179 "MOT-4 an arc from an unknown start
N10 G90 G0 X0 F100
N20 G2 X25 Y0 I10 "the radius is not checked"
"   ^^ W0606
N30 X45 Y0 I10 "the end is known after it"
N40 G30 X0
N50 X10 Y0 I5
"   ^^^ W0606
N60 X20 I5
N70 G30 Y0
N80 X40 Y0 "a missing centre comes first"
"   ^^^ E0602
N90 M30

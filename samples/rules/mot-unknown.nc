%177 "MOT-1 MOT-2 unknown until first programmed in G90
N10 G91
N20 X10
"   ^^^ W0605
N30 X10 "stays unknown, said once"
N40 G90 X5
N50 G91 X5
N60 Y5
"   ^^ W0605
N70 G93 Z100 "GRP-4 neither G91 applies to it nor is it a motion"
N80 Z5
N90 G30 C0 "MOT-7 the values are not used"
N100 C5
"    ^^ W0605
N110 M30

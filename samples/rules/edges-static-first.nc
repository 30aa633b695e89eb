%194 "wrong words do not keep the program from being executed
N10 G91 X5
"       ^^ W0605
N20 G1 X10
"   ^^ W0601
N40 XR1
"   ^^^ W0503
N50 G1 Y5 Y6 "of a repeated word the value is unknown: no W0605
"         ^^ E0306
N55 Z1
"   ^^ W0605
N60 M30

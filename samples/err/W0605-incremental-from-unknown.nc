%605 "Prirustkove odnikud
"MOT-2 once per axis
N10 G91
N20 X10
"   ^^^ W0605
N30 Y5
"   ^^ W0605
N40 X10 Y5
N50 G90 Z100
N60 G91 Z-5
N70 M30

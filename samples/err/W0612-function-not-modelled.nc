%612 "Kopirovani a vlecena osa
"GRP-8 once each
N10 G90 G0 X0 Y0
N20 G5
"   ^^ W0612
N30 G06 X5
"   ^^^ W0612
N40 G7 X10
"   ^^ W0612
N50 G8
"   ^^ W0612
N60 G05 X15
N70 G98
N80 M30

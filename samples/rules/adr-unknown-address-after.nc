%1 "what a letter that is no address would have set is not known
N10 G90 G17 G0 X0 Y0 Z0 F100 S100 M3
N20 G2 E10 Y5 I5
"      ^^^ E0301
N30 G2 X5 Y5 E5
"            ^^ E0301
N40 E1 X5 I5 Y5
"   ^^ E0301
N50 G4 E50
"      ^^^ E0301
N60 G71 E5
"       ^^ E0301
N70 E30
"   ^^^ E0301

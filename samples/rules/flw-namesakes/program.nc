%414 "calls and jumps that mean one another"
"FLW-1 FLW-5 FLW-7 the number that is there says what was meant
N10 G90 G0 X0 Y0
N20 G73 L100
"        ^^^ E0406
N30 G71 L60
"        ^^ E0404
N40 G72 L70
"        ^^ E0405
N50 L9001
"   ^^^^^ W0402
N60 X1
N70 X2
N80 M30
N90 G79 L100
N91 G70

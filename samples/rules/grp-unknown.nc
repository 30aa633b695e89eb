%111 "GRP-1 a G in no group
N10 G11 X1
"    ^^ E0309
N20 G12 X2 G13 "two unknown ones conflict with nothing"
"    ^^ E0309
"           ^^ E0309
N30 G20 X3
"    ^^ E0309
N40 G22 X4
"    ^^ E0309
N50 G25 X5
"    ^^ E0309
N60 G32 X6
"    ^^ E0309
N70 G43 X7
"    ^^ E0309
N80 G52 X8
"    ^^ E0309
N90 G60 X9
"    ^^ E0309
N100 G69 X10
"     ^^ E0309
N110 G76 X11
"     ^^ E0309
N120 G78 X12
"     ^^ E0309
N130 G99 X13
"     ^^ E0309
N140 M30

%110 "GRP-1 two functions of one group
N10 G0 G33 X5
"      ^^^ E0307
N20 G1 G30 X6
"      ^^^ E0307
N30 G17 G14
"       ^^^ E0307
N40 G9 G10
"      ^^^ E0307
N50 G23 G24
"       ^^^ E0307
N60 G40 G42
"       ^^^ E0307
N70 G53 G58
"       ^^^ E0307
N80 G59 G54
"       ^^^ E0307
N90 G94 G97
"       ^^^ E0307
N100 G71 L200 G71
"             ^^^ E0307
N110 G80 G89
"        ^^^ E0307
N120 G90 G91
"        ^^^ E0307
N130 G74 G75
"        ^^^ E0307
N140 G4 Q5 G75 "G04 is in the group of diameter programming"
"          ^^^ E0307
N150 G92 G54 X0 G93
"               ^^^ E0307
N160 G34 G31
"        ^^^ E0307
N170 G35 X0 G39
"           ^^^ E0307
N180 M30
N200 G79 L200
N210 G70

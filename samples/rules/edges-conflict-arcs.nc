%636 "what a conflict leaves unknown hides no other errors"
"GRP-1 MOT-3 MOT-4 an arc with two axis words needs no group but G0, G9 and G10
N10 G0 X0 Y0 F100 D1
N20 G41 G42
"       ^^^ E0307
N30 G2 X10 Y0 I4
"             ^^ E0603
N40 G2 X30 Y0
"   ^^ E0602
N50 G3 X50 Y1 K3
"   ^^ E0602
"             ^^ E0609
N60 G17 G18
"       ^^^ E0307
N70 G2 X60 Y1 I4
"             ^^ E0603
N80 G2 X60 I4
N90 G40 G17 G0 X0 Y0
N100 G81 G82
"        ^^^ E0307
N110 G2 X10 Y0 I4 "it may be a cycle; what is wrong with the arc is wrong"
"              ^^ E0603
N120 G2 X30 Y0
"    ^^ E0602
N130 G3 X50 Y1 K3
"    ^^ E0602
"              ^^ E0609
N140 G1 X5 "a cycle, or not: nothing is known after it"
N150 G91 X5
N160 M30

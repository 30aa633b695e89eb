%123 "GRP-7 I with G23 in a block that is no arc
N10 G90 G0 X0 Y0 F100
N20 G23 I1
N30 G1 G23 X10 I4
N40 X20 I2
"       ^^ E0609
N50 G23 J1
"       ^^ E0609
N60 G24
N70 G1 X30 I1
"          ^^ E0609
N80 G2 X50 Y0 I10
N90 G23 I3 "G02 in force, no axis words: no arc"
N100 G23 X70 Y0 I10 "an arc: I is the centre"
N110 M30

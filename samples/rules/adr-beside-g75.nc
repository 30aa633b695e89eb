%637 "ranges beside G74 and G75"
"ADR-2 they hold beside every G function of this control
N10 G75 G0 X0 F100 D100
"                   ^^^ E0302
N20 G74 P100
"        ^^^ E0302
N30 G75 P0
"        ^ E0302
N40 G75 Q0
"        ^ E0302
N50 G74 Q999990
"        ^^^^^^ E0302
N60 G75 L0
"        ^ E0302
N70 G74 L99999
"        ^^^^^ E0302
N80 M30

%737 "H beside G74 and G75"
"! dialect=cnc8x6
"ADR-2 the range of this control holds there too
N10 G75 G0 X0 H1
N20 G74 H0
"        ^ E0302
N30 G75 H0
"        ^ E0302
N40 M30

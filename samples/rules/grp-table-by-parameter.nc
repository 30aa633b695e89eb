%139 "GRP-4, GRP-8 a table by a parameter takes no I and J either"
N10 G90 G0 X0 Y0 Z5 R1=92
N20 GR1 X5 I5 J1
"          ^^ E0609
N30 M30

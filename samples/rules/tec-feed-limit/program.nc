%154 "TEC-1 the limit of this machine
N10 G90 G0 X0 Z0
N20 F500
N30 F500.5
"    ^^^^^ E0302
N40 M30

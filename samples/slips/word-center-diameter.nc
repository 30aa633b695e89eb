%1 "souradnice stredu jako prumer"
N10 G54 G74 G19 G95
N20 T1 D1 M6
N30 S800 M3 F0.2
N40 G0 X24 Z0
N50 G3 X30 Z-3 I24 J-3
"              ^^^ E0603
N60 G0 X60 Z100
N70 M30

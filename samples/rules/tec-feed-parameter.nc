%160 "PAR-3 TEC-1 a feed from a parameter obeys the same range
N10 R1=0.5 R2=100 G90 G0 X0 Z0 S800 M3
N20 F50
N30 FR1
"   ^^^ E0510
N40 FR2
N50 G95
N60 FR2
"   ^^^ E0510
N70 FR1
N80 M30

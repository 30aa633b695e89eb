%1 "cislice bez klavesy Shift"
N10 G54 G90 G94 G0 X0 Y0 Z50
N20 T1 M6
N30 S900 M3
N40 G1 X+šé Y5 F200
"      ^^^^ E0101
N+žé G0 Z50
"@ 7:1-7:5 E0101
N170 M30

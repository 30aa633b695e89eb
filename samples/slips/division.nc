%1 "deleni za hodnotou parametru"
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 G1 Z-2 F300
N50 Y20
N60 R10=-24/2 R11=5
"   ^^^^^^^^^ E0106
N65 R12=-R11/2
"   ^^^^^^^^^^ E0106
N80 G0 Z50
N90 M30

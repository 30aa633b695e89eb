%1 "typografické minus před parametrem"
N10 G54 G90 G0 X0 Y0 Z50 R10=5
N20 T1 M6
N30 S1200 M3
N40 G1 Z-2 F300
N50 G1 X−R10 R11=−R10
"      ^^^^^ E0101
"                ^^^^ E0101
N60 Y+R11
N80 G0 Z50
N90 M30

%1 "K misto J: jedna zavada, polomery oblouku se neposuzuji
N10 G54 G17 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 G1 Z-1 F300
N50 G2 X10 Y10 I10
N60 G2 X30 Y-10 I3 K-15
"                  ^^^^ E0609
N70 G0 Z50
N80 M30

%1 "znamenko misto cislice ve funkci skoku"
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 G1 Z-2 F300
N50 G+3 L40 Q2
"    ^^ E0305
N80 G0 Z50
N90 M30

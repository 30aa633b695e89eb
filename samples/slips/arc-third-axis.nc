%1 "cislice zmacknuta jako Z: oblouk nevychazi, o G09 nejde
N10 G54 G17 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 G1 Z-1 F300
N50 G2 X1Z0 Y10 I0 J10
"               ^^ E0603
N60 G0 Z50
N70 M30

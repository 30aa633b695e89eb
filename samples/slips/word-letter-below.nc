%1 "pismeno pod klavesou cislice"
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 G1 Z-2 F300
N50 Xq0
"   ^ E0103
N60 G0 Zt0
"      ^ E0103
N90 M30

%1 "Z misto N v bloku, ktery skace sam na sebe"
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 G1 Z-2 F300
Z50 G73 L50 Q2
"@ 6:1-6:4 E0306
"        ^^ E0406
N80 G0 Z50
N90 M30

%1 "polomer, oblouk plati z predchoziho bloku"
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 G1 Z-2 F300
N50 G2 X10 Y0 I5
N60 X0 R-12.5
"      ^^^^^^ E0106
N80 G0 Z50
N90 M30

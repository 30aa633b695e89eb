%1 "uvozovka uvnitr cisla a komentar"
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 G1 Z-2 F300
N50 G1 X1“0 Y2 "D16"
"        ^ E0105
N52 X1"0 Y2 "konec"
"            ^^^^^ E0111
N80 G0 Z50
N90 M30

%1 "chybi adresa za funkci se dvema cislicemi"
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 G1 Z-2 F300
N50 G00 1
"   ^^^^^ E0102
N90 M30

%1 "zapomenute adresy: dohromady by cisla byla vetsi, nez adresa bere"
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 G1 Z-2 F24000 0
"          ^^^^^^^^ E0102
N50 Y20
N60 Z37 0400
"   ^^^^^^^^ E0102
N80 G0 Z50
N90 M30

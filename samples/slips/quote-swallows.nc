%1 "chybi uvozovky pred komentarem, za nim jsou slova"
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3 vreteno" N40 G1 Z-2 F300
"            ^^^^^^^ E0111
N90 G0 Z50
N100 M30

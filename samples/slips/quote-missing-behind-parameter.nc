%1 "chybi prvni uvozovka za parametry"
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 R10=-2 R11=150 R12=2 hloubka"
"                        ^^^^^^^ E0111
N50 G1 ZR10 FR11
N60 G71 L200 QR12        D45 dve drazky"
"                            ^^^^^^^^^^ E0111
N70 G0 Z50
N80 M30
N100 G79 L200
N110 G91 X5
N120 G90 G70

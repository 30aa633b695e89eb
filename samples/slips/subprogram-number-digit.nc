%1 "cislo podprogramu s cislici navic; takovy blok tu je"
N10 G54 G90 G94 G0 X0 Y0 Z50
N20 T1 M6
N30 S900 M3
N40 G71 L10
"        ^^ E0404
N50 G0 Z50
N60 M30
N70 G79 L110
N80 G1 Z-3 F100
N90 G70

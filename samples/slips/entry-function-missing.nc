%1 "podprogram bez G79, jen s L"
"PRG-3 FLW-7 the call says that G79 is missing: its L needs no warning
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 G71 L100
"        ^^^ E0404
N50 M30
N100 L100
N110 G1 X40 F300
N120 Y40
N130 G70

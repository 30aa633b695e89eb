%1 "cislo pod otevrenou poznamkou
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6 S1200 M3
N30 G1 X40 F300 "open
 40 Y20
N50 M30
"@ 5:2-5:4 E0106

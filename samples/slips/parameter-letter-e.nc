%1 "E misto R u prirazeni
N10 G54 G90 G0 X0 Y0 Z50 E12=-3
"                        ^^^^^^ E0301
N20 T1 M6
N30 S1200 M3 F250
N40 G1 ZR12
N50 G0 Z50
N60 M30

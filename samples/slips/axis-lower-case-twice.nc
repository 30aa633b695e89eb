%1 "x misto G: rozpor ma obe slova, o malem pismenu nic navic
N10 G54 G17 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3 F300
N40 G1 Z-1
N50 x02 X20
"       ^^^ E0306
N60 G0 Z50
N70 M30

%-12 "table of addresses: no sign
"^^^ E0305
N10 G90 G0 X0 Y0
N20 M30

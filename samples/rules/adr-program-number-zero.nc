%0 "table of addresses: 1 to 999999
"^ E0302
N10 G90 G0 X0 Y0
N20 M30

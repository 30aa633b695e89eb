%12.5 "table of addresses: no decimal point
"^^^^ E0304
N10 G90 G0 X0 Y0
N20 M30

%1000000 "Sedm cislic
"^^^^^^^ E0302
N10 G90 G0 X0 Y0
N20 M30

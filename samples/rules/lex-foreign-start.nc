%
O2107
"@ 1:1-1:2 E0103
N10 G90 G0 X0 Y0 "LEX-4 the number of the program as other controls write it"
N20 M30

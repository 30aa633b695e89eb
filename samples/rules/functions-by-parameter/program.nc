%1 "PAR-3 ADR-3 functions from parameters get what written ones get
N10 R1=18 R2=26 R3=71
N20 GR1
"   ^^^ W0616
N30 GR2 R5=1010101 R6=5
"                  ^^^^ W0506
N40 G71 L1
N50 M30
N60 G79 L1
N70 GR3 L2
"   ^^^ W0414
N80 G70
N90 G79 L2
N100 G70

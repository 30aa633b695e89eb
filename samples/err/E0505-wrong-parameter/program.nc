%505 "Ridici slovo v jinem parametru
"PAR-7 the control word of G26 is in R6: one finding
N10 R10=5 R11=2
N20 G26 R6=01101112
"   ^^^ E0505
N30 M30

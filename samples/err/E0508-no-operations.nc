%5081 "Tabulka operaci chybi
N10 R10=5 R11=2
N20 G26 R5=01101112
"          ^^^^^^^^ E0508
N30 M30

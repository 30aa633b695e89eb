%506 "Ridici slovo navic
"PAR-7 G26 uses R5 alone, G27 R5 and R6
N10 R10=5 R11=2
N20 G26 R5=01101112 R6=02101113
"                   ^^^^^^^^^^^ W0506
N30 G27 R5=01101112 R6=02101113 R8=1
"                               ^^^^ W0506
N40 R7=5 R8=6 "R5 to R8 are ordinary here
N50 M30

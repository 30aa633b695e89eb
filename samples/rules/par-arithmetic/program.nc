%54 "PAR-7 PAR-8 control words
N10 R10=5 R11=2 R12=0
N20 G27 R5=01101112 R6=04101213 "each sees the results before: R12 is 7"
N30 G28 R5=1101114 R6=-3101115 R7=06100016
N40 G29 R5=01101120 R6=02101121 R7=03101122 R8=04101123
N50 R5=1 R6=2 R7=3 R8=4 "no function: ordinary parameters"
N60 R30=01101131
N70 G26 R5=R30 "a control word by copy"
N80 G27 R5=01101106 R6=01101132 "a result does not change the control words"
N90 R10=4 G26 R5=01101133 "PAR-4 operands are no words: no warning"
N100 G26 R5=01101195 "R95 as a result is not written out"
N110 X5 "PAR-7 holds in its own block"
N120 XR13 YR20 ZR31
N130 G26 R5=06109934 "neg has one operand, bb is not looked at"
N140 M30

%509 "Vypocet nevyjde
"PAR-10 division by zero, root of a negative number, result too large
N10 R10=5 R11=0 R12=-4 R13=50000 R14=0.4
N20 G26 R5=04101120
"          ^^^^^^^^ E0509
N30 G26 R5=05120021
"          ^^^^^^^^ E0509
N40 G26 R5=01131322
"          ^^^^^^^^ E0509
N50 G26 R5=-01131323 "whole numbers reach farther
N60 G26 R5=-04101424 "0.4 is 0 as a whole number
"          ^^^^^^^^^ E0509
N70 G26 R5=04101425
N80 G26 R5=07100026 "asin 5
"          ^^^^^^^^ E0509
N90 G26 R5=09101127 "mod 0
"          ^^^^^^^^ E0509
N100 R15=90
N110 G26 R5=08150028 "tan 90
"           ^^^^^^^^ E0509
N120 M30

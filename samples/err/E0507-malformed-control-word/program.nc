%507 "Spatne ridici slovo
"PAR-8 a whole number oo aa bb rr, the fields up to 95
N10 R10=5 R11=2
N20 G26 R5=1.5
"          ^^^ E0507
N30 G26 R5=01961112
"          ^^^^^^^^ E0507
N40 G26 R5=-01109712
"          ^^^^^^^^^ E0507
N50 G26 R5=01101199
"          ^^^^^^^^ E0507
N60 G26 R5=06109912 "bb is ignored with one operand
N70 M30

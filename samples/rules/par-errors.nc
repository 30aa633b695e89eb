%41 "PAR-1 PAR-2 what is no assignment and no use
N10 R10R11=5 "an R word needs a value"
"   ^^^ E0103
N20 R12= X5
"   ^^^^ E0103
N30 R13
"   ^^^ E0103
N40 XR11 25.5 "a split number"
"   ^^^^^^^^^ E0102
N50 XR96 Y5
"     ^^ E0501
N60 R96=5
"    ^^ E0501
N70 R14=R97
"        ^^ E0501
 NR11 X7
"^^^^ E0511
N80 R95=5 R94=5
"   ^^^^^ W0502
N90 M30

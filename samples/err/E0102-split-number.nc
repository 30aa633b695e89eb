%102 "Mezery uvnitr cisla
"LEX-3 a space may stand after the address, not inside the number
N10 G90 G0 X  36.12 Y 0 S800 M3
N20 G1 X36.  12 F200
"      ^^^^^^^^ E0102
N30 Y-  36.12
"   ^^^^^^^^^ E0102
N40 X1 000 F2 50
"   ^^^^^^ E0102
"          ^^^^^ E0102
N50 Y10 .5
"   ^^^^^^ E0102
N60 R10=12.5
N70 R11=2. 5
"   ^^^^^^^^ E0102
N80 G0 1 X20
"   ^^^^ E0102
N90 XR10 25.5
"   ^^^^^^^^^ E0102
N95 X- R10 5
"   ^^^^^^^^ E0102
N100 S12 00 M3
"    ^^^^^^ E0102
N105 R12=-  R13
"    ^^^^^^^^^^ W0503
"    ^^^^^^^^^^ E0102
N107 R12=-  R13 5 "which of the two blanks is wrong?
"    ^^^^^^^^^^^^ E0102
N108 R12= - 5 6
"    ^^^^^^^^^^ E0102
N109 R12= - 5
"    ^^^^^^^^ E0102
N110 M30

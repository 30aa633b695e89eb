%106 "Vyrazy
"PAR-1 PAR-2 the value of a parameter is a number or another parameter
N10 R1=5 R2=1
N20 R10=R1+5
"   ^^^^^^^^ E0106
N30 R11=5+3
"   ^^^^^^^ E0106
N40 G90 G0 XR1+5
"          ^^^^^ E0106
N50 X=45
"   ^^^^ E0106
N55 R12==5 Y3
"   ^^^^^^ E0106
N56 R50=R1+R2 Y4
"   ^^^^^^^^^ E0106
N57 R13=R1 + R2 - 5
"   ^^^^^^^^^^^^^^^ E0106
N58 XR1-R2
"   ^^^^^^ E0106
N60 M30

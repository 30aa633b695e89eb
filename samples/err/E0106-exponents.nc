%106 "Cisla s exponentem za adresami bez desetinne tecky
"§13 a number with an exponent is one finding, whatever its address
N10 G90 G0 X0 Y0 Z50 T1E0 D1E0
"                    ^^^^ E0106
"                         ^^^^ E0106
N20 S1.2E+03 M3
"   ^^^^^^^^ E0106
N30 H1E1 S1.25E1
"   ^^^^ E0106
"        ^^^^^^^ E0106
N40 G73 L5E1 Q2E0
"       ^^^^ E0106
"            ^^^^ E0106
N5E1 G1 X5 F100
"@ 14:1-14:5 E0106
N60 XNAN(ind) Y1
"   ^^^^^^^^^ E0106
N65 G1 X30 FFMAX
"          ^^^^^ E0106
N66 XFMAX Y -FMAX
"   ^^^^^ E0106
"         ^^^^^^^ E0106
N70 G3 X20 Y0 I=AC(35) J=IC(10)
"             ^^^^^^^^ E0106
"                      ^^^^^^^^ E0106
N80 M30

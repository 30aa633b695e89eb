%106 "Pokazena cisla
"LEX-2 a number has one sign and one point at most
N10 G90 G0 X1.2.3 Y0
"          ^^^^^^ E0106
N20 G1 X--5 F200
"      ^^^^ E0106
N30 Y+-2 X10
"   ^^^^ E0106
N40 "zustala jen hodnota" -12.5 X20
"                         ^^^^^ E0106
N50 G0 X0
 25 Y5
"^^ E0106
N60 M30

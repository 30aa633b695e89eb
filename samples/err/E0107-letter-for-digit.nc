%107 "O misto nuly
"LEX-12 the letter O is no zero, the letter l no one
N10 G90 GO XO Y0
"       ^^ E0107
"          ^^ E0107
N20 S1OOO M3
"   ^^^^^ E0107
N30 G1 X1O0 F200
"      ^^^^ E0107
N40 Yl0
"   ^^^ E0107
N50 X5 "GOLIAS je v komentari"
N60 M3O
"   ^^^ E0107

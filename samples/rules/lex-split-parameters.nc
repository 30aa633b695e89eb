%5 "LEX-3 blanks in a copy of a parameter; a letter in its number is told alone
N10 R1=R2 5
"   ^^^^^^^ E0102
N20 RO=R2 5
"   ^^ E0107
N30 R1=RO 5
"      ^^ E0107
N40 R1=R2 -5
"   ^^^^^^^^ E0106
N50 M30

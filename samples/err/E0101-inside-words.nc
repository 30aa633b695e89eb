%110 "Znaky uvnitr slov: jedna chyba, jedno hlaseni
"LEX-13 LEX-2 outside comments the text is ASCII; a word keeps its place
N10 G90 G0 X0 Y0 Z50 R1=0
N20 G1 Z−4.2 F200
"   ^^ W0619
"      ^^^^^ E0101
N30 X#1 Y5
"   ^^^ E0101
N40 X[R1+5] Y6
"   ^^^^^^^ E0101
N50 X1–5
"   ^^^^ E0101
N60 X４５ Y7
"   ^^^ E0101
N70 Х8 Y8
"   ^^ E0101
N80 R10:=5 R11=2
"   ^^^^^^ E0101
N90 G1 X10° Y9;
"         ^ E0101
"@ 19:15-19:16 E0101
N110 T1 M06 'Vrtak D9' S900
"           ^^^^^^^^^^ E0101
N120 T1 `Vrtak D9`
"       ^^^^^^^^^^ E0101
N130 T1 (Vrtak D9)
"       ^^^^^^^^^^ E0101
N140 M30

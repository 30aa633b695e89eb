"@ 21:9-21:10 E0103
%103 "Slova bez hodnoty
"LEX-4 a word that carries zero still needs one digit
N10 G90 G0 X Y0
"          ^ E0103
N20 G1 Y- F200
"   ^^ W0619
"      ^^ E0103
N30 X. S800
"   ^^ E0103
N40 R10 X5
"   ^^^ E0103
N50 R11= Y5
"   ^^^^ E0103
N60 M X10
"   ^ E0103
N70 G X15
"   ^ E0103
N80 X12 Y "LEX-3 a comment leaves Y without a value" R2=5
"       ^ E0103
N90 X14 Y
R3=5 "LEX-3 so does a line end: R3=5 is an assignment of its own
"@ 22:1-22:5 W0221
N100 X0 F
"       ^ E0103
N110 M30

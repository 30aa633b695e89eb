%1004 "LEX-3 LEX-4 LEX-12 numbers that are none
N10 G90 G0 X36.	12 Y0 "LEX-3 a tab is a space"
"          ^^^^^^^ E0102
N20 X-	5 Y+ 5
"   ^^^^ E0102
"        ^^^^ E0102
N30 X1 2 3
"   ^^^^^^ E0102
N40 R10 25.5 R11  4 "the first number is the value of R"
N50 R12 25. 5
"   ^^^^^^^^^ E0102
N60 S8 00 M0 3
"   ^^^^^ E0102
"         ^^^^ E0102
N70 G0 1 G0 "what is only offered is not known"
"   ^^^^ E0102
N80 X36,12 X5
"   ^^^^^^ E0104
"          ^^ E0306
N90 XO X5
"   ^^ E0107
"      ^^ E0306
N100 X1.2.3 X5 "a word without a value takes no part: one X only"
"    ^^^^^^ E0106
N110 X X5
"    ^ E0103
N120 XO.5 Y1O.5 Zl5
"    ^^^^ E0107
"         ^^^^^ E0107
"               ^^^ E0107
N130 "LEX-3 after a comment" 5 X5
"                            ^ E0106
N140 Y "LEX-3 the comment parts them" R13=5
"    ^ E0103
N150 M3 0
"    ^^^^ E0102

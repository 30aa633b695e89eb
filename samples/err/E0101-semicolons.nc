%101 "Stredniky pred slovy
"§13 what is behind a semicolon is a comment on other controls, words too
; N10 X5
"@ 3:1-3:9 E0101
N20 G90 G0 X1 ;Y5 Z3
"             ^^^^^^ E0101
N30 X2 ; X50 "old" Y3
"      ^^^^^^^^^^^^^^ E0101
# N40 X5
"@ 9:1-9:9 E0101
N50 X3; N60 X4
"     ^ E0101
N70 X5;
"     ^ E0101
N80 M30

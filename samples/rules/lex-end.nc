%1018 "LEX-9 the asterisk ends the program and its subprograms
N10 G90 G0 X0 Y0
N20 M30*

 "only comments after it" "and more of them"
"X1.2.3 ; E5

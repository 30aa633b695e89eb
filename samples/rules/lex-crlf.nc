%1012 "LEX-8 CR LF
N10 G90 G0 X0 Y0 "LEX-6 a comment never crosses a line end
N20 X5 X6
"      ^^ E0306
N30 Y5 "LEX-7 the line end excluded xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx
N40 M30
*

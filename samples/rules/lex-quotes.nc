%1022 "LEX-12 typographic quotes
N10 G90 G0 “X5" Y0
"          ^ E0105
N20 X5 „X6 up to the end of the line
"      ^ E0105
N30 X7 "a straight comment holds “ and ” and „ unharmed" Y7
N40 M30

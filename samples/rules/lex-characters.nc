%1005 "LEX-13 outside comments the text is ASCII
N10 G90 G0 X0 Y0 "a no-break space"
"         ^ E0101
N20 X5 Y5 "vertical tab and form feed are no blanks"
"     ^ E0101
"         ^ E0101
N30 X6  Y6
"     ^ E0101
N40 X7 ěšč Y7 ř ž
"      ^^^ E0101
"             ^ E0101
"               ^ E0101
N50 X8 Y8 "Ctrl-Z in the middle"
"     ^ E0101
N60 "abcd e" X9 X9 "in a comment they end no line"
"                  ^^ E0306
N70 M30

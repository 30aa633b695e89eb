%1003 "LEX-2 words: an address and its number
"LEX-6 a comment may stand before the first block
N10G90G0X0Y0S800M3
N20 G1 X  36.12 F	200 "LEX-3 spaces between address and number"
N30	X384.	Y.12 "LEX-3 tabs count as spaces, LEX-4 zeros may be left out"
N0040 X-.5 Y-0 M03 "LEX-4 M03 is M3"
N50 X+.5 Y+1. "LEX-5 a plus may be written"
N60 "LEX-6 between" X1 "any two" Y2 "words"
"LEX-6 alone on a line
N70 "" X2 "" Y3 "also empty ones, and up to the end of the line
N80 /1 X3 "LEX-10 digits after a slash are not evaluated"
N90 / 007 X4
N100 X5 /2 Y5
N110 X6 "LEX-13 anything may stand here: ; # $ ( ) ž é ⟨ “ ” „ E5 XO 1,5"
N120 / X7
N130 M30

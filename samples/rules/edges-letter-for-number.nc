%1 "a letter in place of a number that a function of the block needs
"§13 one mistake is one finding
N10 G54 G90 G17 G00 X0 Y0
N20 G01 X5 F100
N30 G71 LX
"       ^^ E0111
N40 G04 QX
"       ^^ E0111
N50 G90 G00 X0 Y0 Z0
N60 G02 X10 Y0 IX
"              ^^ E0111
N70 G01 X5 LX
"          ^^ E0111
N80 M30
N90 G79 L5
N100 G70

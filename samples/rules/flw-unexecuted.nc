%103 "FLW-11 what is never executed gets the checks that need no execution
N10 G90 G0 X0 Y0
N20 G73 L40
N30 G1 X5 L5 "no feed is missed here"
"         ^^ W0402
N40 M30
N100 G79 L100
"    ^^^ W0211
N110 G1 X0.00049 YR50
"        ^^^^^^^ W0303
N120 G91 Z5
N130 G70

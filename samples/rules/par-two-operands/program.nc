%199 "each operand is read, and neither has a value
N10 G26 R5=1010203
"          ^^^^^^^ W0503
"          ^^^^^^^ W0503
N20 G0 XR1 YR2
N30 M30

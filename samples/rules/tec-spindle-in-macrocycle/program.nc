%262 "TEC-7 a written call leads to what starts the spindle
N10 G90 G0 X0
N20 G1 X10 F100
"   ^^ W0619
N30 G72 L8
N40 X20
N50 M30

%193 "levels from the project file, by code or name
N10 G90 G0 X0 Y0
N20
N30 L5 X5
N40 Q5
"   ^^ W0403
N50 M30

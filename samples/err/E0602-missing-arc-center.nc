%602 "Kruh bez stredu
"MOT-4 both I and J missing or zero; R is a parameter, no radius
N10 G90 G0 X0 Y0
N20 G1 X10 F200
N30 G2 X30 Y0
"   ^^ E0602
N40 G3 X10 Y0 R5=10
"   ^^ E0602
N50 G3 X0 Y0 I0 J0
"   ^^ E0602
N60 M30

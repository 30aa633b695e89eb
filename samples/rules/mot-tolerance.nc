%175 "MOT-4 0.01 mm or a thousandth of the radius; equal is allowed
N10 G90 G0 X0 Y0 F100
N20 G2 X20.01 Y0 I10
N30 G0 X0
N40 G2 X20.011 Y0 I10
"                 ^^^ E0603
N50 G0 X0 Y0
N60 G2 X200.1 Y0 I100
N70 G0 X0
N80 G2 X200.102 Y0 I100
"                  ^^^^ E0603
N90 G0 X0 Y0
N100 G2 X2.01 Y0 I1
N110 G0 X0
N120 G2 X1.98 Y0 J0 I1
"                   ^^ E0603
N130 G0 X0 Y0
N140 G2 X0 Y9.5 J5
"               ^^ E0603
N150 M30

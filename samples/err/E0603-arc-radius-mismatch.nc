%603 "Konec neni na kruznici
"MOT-4 0.01 mm or a thousandth of the radius
N10 G90 G0 X0 Y0
N20 G2 X20.5 Y0 I10 J0 F200
"               ^^^ E0603
N30 G3 X20.5 Y10 J4
"                ^^ E0603
N40 G2 X40.5 Y10 J0 I10
N50 X45 Y10 J1 I2
"              ^^ E0603
N60 M30

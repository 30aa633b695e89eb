%1
N10 G00 X0
N20 G01 X0 Y10.001 F200 S500 H1 T12 M03 "a comment that is rather long, as they are" "a comment that is rather long, as they are"
N30 M30

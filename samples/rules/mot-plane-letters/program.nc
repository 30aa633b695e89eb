%1 "stred slovem K, I a J v poradi roviny"
"MOT-3 with `plane-order` I belongs to Z in the plane ZX, and J to X
N10 G90 G94 G0 X30 Y0 Z0 M03 S500
N20 G19 G3 X35 Z-5 I0 K-5 F100
"                     ^^^ E0609
N30 G18 G3 Y5 Z-10 J0 K-5
"                     ^^^ E0609
N40 M30

%416 "M30 in place of M03"
"PRG-2 the end that is meant stands behind
N10 G90 G0 X0 Y0
N20 S900 M30
N30 G1 X5 F100
"@ 5:1-5:4 E0206
N40 X0
N50 M30

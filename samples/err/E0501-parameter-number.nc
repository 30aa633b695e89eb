%501 "Parametry nad R95
"there are R0 to R95
N10 G90 G0 X0 Y0
N20 R96=5
"    ^^ E0501
N30 R100=2.5 X5
"    ^^^ E0501
N40 M30

%1 "another control's cycle behind a sign: its finding is not lost"
N10 G00 X0 Y0
N20 -G71 R96=1
"    ^^^ E0401
N30 M30

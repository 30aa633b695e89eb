%102 "FLW-7 GRP-5 what needs L, what needs Q
N10 G90 G0 X0 Y0
N20 X5 G71 Q2
"      ^^^ E0401
N30 G73
"   ^^^ E0401
N40 G4 G71 L100
"   ^^ E0411
N50 G72 L "one fault, one finding"
"       ^ E0103
N60 M30
N100 G79 L100
N110 G0 X5
N120 G70

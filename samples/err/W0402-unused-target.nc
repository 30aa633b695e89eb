%402 "L bez volani
"FLW-7 L without G71 G72 G73 G79"
N10 G90 G0 X0 Y0
N20 L100 X5
"   ^^^^ W0402
N30 G4 Q50 L9001
"          ^^^^^ W0402
N40 M30

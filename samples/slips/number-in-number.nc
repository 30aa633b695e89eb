%1 "pismeno N navic: Q za nim patri ke skoku"
N10 G54 G90 G0 X0 Y0 Z50
N20 X5
N30 G73 NL20 Q1
"   ^^^ E0401
"       ^ E0103
N60 M30

%1 "pismeno N navic: prazdny blok a Q patri k nemu"
N10 G54 G90 G0 X0 Y0 Z50
N20 X5
N30 G73 NL20 Q1
"   ^^^ E0401
"       ^ E0103
N40 X7 N20
"      ^^^ E0204
N60 M30

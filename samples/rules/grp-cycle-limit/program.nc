%118 "GRP-6 a mapped cycle is called after every block with a motion: 15 records
N10 G90 G0 X0 Y0 Z0
N20 G81 X10
N30 X20
N40 M8 "no motion"
N42 G92 G54 X5 "data"
N44 G30 Z0 "reference point"
N46 G4 Q5
N50 G80 X30
 N60 M30
"^^^ E0410

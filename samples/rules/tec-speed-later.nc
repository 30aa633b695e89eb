%623 "S in a later block than the cut"
"TEC-8 in a program that writes S; after it there is nothing to say
N10 G0 X0 Y0 F100 M3
N20 G1 X50
"   ^^ W0622
N30 S500
N40 G1 X60
N50 M5
N60 G0 X0
N70 M30

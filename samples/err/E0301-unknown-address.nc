%301 "Adresy odjinud
"table of addresses: there is no E and no O
N10 O1000 G90
"   ^^^^^ E0301
N20 G0 X0 Y0 E5
"            ^^ E0301
N30 G1 X10 F200 E-0.5
"               ^^^^^ E0301
N40 M30

%8 "table of addresses: E and O are none
N10 G90 G0 X0 Y0 E5
"                ^^ E0301
N20 O123 X5 E-1.5
"   ^^^^ E0301
"           ^^^^^ E0301
N30 M30

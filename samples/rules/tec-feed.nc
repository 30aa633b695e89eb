%150 "TEC-1 by the G6 function in force in the block that writes the feed
N10 G90 G0 X0 Z0 S800 M3
N20 G95 F0.15
N30 G1 X5
N40 F100 X6
"    ^^^ E0302
N50 G95
N60 F150.5 X7
"    ^^^^^ E0302
N70 F99.999
N80 G96
N90 F0.15 X8
"    ^^^^ E0302
N100 F150
N110 G94
N120 F0.999
"     ^^^^^ E0302
N130 F1
N140 G95 X9 "TEC-1 its range is not checked again, its unit is"
"        ^^ W0615
N142 X10 "once for each F"
N144 G0 G94 X11
N146 G1 G97 X12 "per minute on CNC872"
N150 M30

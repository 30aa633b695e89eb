%181 "MOT-4 arcs under the wrong one of G90 and G91
N10 G90 G0 X0 Y0 Z0 M3 S1000 F100
N20 G91 G2 X10 Y0 I5
N30 X20 Y0 I5 "positions are written: one finding"
"          ^^ E0603
N40 X30 Y0 I5
N50 G71 L1 "what the subprogram moves is not known to them"
N60 G2 X30 Y0 I5
"             ^^ E0603
N70 G90 G1 X60 Y0
N80 G2 X30 Y0 I15 "another sign fits: an error of its own each time"
"             ^^^ E0603
N90 G1 X60
N100 G2 X30 Y0 I15
"              ^^^ E0603
N110 M30
N200 G79 L1
N210 G1 X100
N220 G70

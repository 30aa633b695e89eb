%155 "TEC-2 G01 G02 G03 are working motions
N10 G90 G0 X0 Y0 Z0 S100 M3
N30 G30 X0 "nor is G30"
N40 G0 X0 Z0
N50 G1 "no axis word, no motion"
N60 G1 G92 G54 X5 "data"
N70 G0 X0 Y0
N80 G3 X20 Y0 I10
"   ^^ W0601
N90 G1 X5 "once per program"
N100 M30

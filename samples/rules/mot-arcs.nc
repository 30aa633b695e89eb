%170 "MOT-3 MOT-5 MOT-6 arcs in order
N10 G90 G0 X0 Y0 Z0 F100
N20 G2 X20 Y0 I10 J0
N30 G3 X0 I-10 "one axis word: the active plane"
N40 G2 I5 "none: a full circle"
N50 X0 Y0 J5 "MOT-4 end = start is a full circle too"
N60 G1 X0 Z0
N70 G2 X20 Z0 I10 "two words: their plane, whatever G17 says"
N80 G3 Z0 X0 I-10
N90 G19 G2 X20 Z0 I10 J0
N100 X0 I-10
N110 Z10 J5 "I is along X and J along Z, also for G19"
N120 G18 G3 Y10 I5
N130 Y20 Z10 I5
N140 G17 G9 G2 X20 Y20 Z5 I10 K3 "with G09 K goes into the record"
N150 G98
N160 G3 X0 Y20 I-10 R5=10 "R is a parameter here"
N170 M30

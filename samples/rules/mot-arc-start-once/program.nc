%202 "MOT-4: W0606 once for an axis until its position is known, with ChangePos
N10 G91 G03 X0 Y0 I9 F100
"       ^^^ W0606
N20 T1 M06
N30 X0 Y0 I9
N40 M30

%804 "G24 needs 30 ms for a block"
"S3 A2, counted by the time of the motion
N10 G54 G90 G24
N20 G00 X0 Y0 F600
N30 G01 X10
 N40 X10.01
"^^^ W0804
N50 X10.5
N60 G23 X10.51
N70 G01 X10.52
N80 M30

%139 "MFN-4 what moves the machine acts before the motion, or at its end
N10 G90 G0 X0 Y0 F100 T1
N20 X10 Y0 M6 "known after it
N30 G2 X20 I5
N40 X30 M60
"   ^^^ E0602
N50 G2 X20 Y0 I5
"   ^^ W0606
N60 M30

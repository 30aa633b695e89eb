%124 "GRP-7 the sets are 1 to 4
N10 G90 G0 X0 Y0
N20 G23 I5
"        ^ E0302
N30 G23 I0
"        ^ E0302
N40 G23 I4
N45 R1=7 R2=2.5
N46 G23 IR1
"       ^^^ E0510
N47 G23 IR2
"       ^^^ E0510
N50 M30

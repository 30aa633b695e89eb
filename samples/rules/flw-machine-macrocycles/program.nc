%412 "macrocycles that only the machine has"
"FLW-12 one finding; none of what follows from unknown positions
N10 G90 G0 X0 Y0 Z5 F100
N20 G72 L9004
N30 G72 L9003
"        ^^^^ W0612
N40 G2 X10 Y0 I5 J0
N50 G72 L9002 Q3
N60 G91 G1 Z1
N70 G90 G2 X20 I5 J0
N80 R1=9001
N90 G72 LR1
N100 G91 G1 X1
N110 G90 G2 X20 Y0 I5
N120 G81 G1 X5 Y5
N130 G80 M30

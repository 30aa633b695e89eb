%197 "PAR-9 the parameter that receives the result is unknown
N10 R1=1 R2=2 R3=-5 R20=01010203 S800
N20 G26 R5=01010202
"          ^^^^^^^^ E0508
N30 G26 R5=R20 "the same operation by a copy: said once
N40 G90 G1 XR3 F200
"       ^^ W0619
N45 G95 FR3 Y1
N50 X1 FR1 "R1 is known
N60 G94 XR2 FR3
N70 G73 L60 QR1
N80 M30

%44 "PAR-4 the words read the values from before the block
N10 R1=2.5 R2=3 G90 G0 X0 Y0
N20 R1=3 SR1 "2.5 is no speed"
"        ^^^ E0510
"        ^^^ W0504
N30 R2=2.5 SR2 "3 is one"
"          ^^^ W0504
N40 SR1 "now R1 is 3"
N50 R3=5 R4=6
N60 R3=1 R4=R3 "a copy reads too"
"        ^^^^^ W0504
N70 XR4
N80 M30

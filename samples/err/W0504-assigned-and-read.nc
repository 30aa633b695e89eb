%504 "Prirazeni a cteni v jednom bloku
"PAR-4 the words read the values from before the block
N10 R1=5 R2=6 G90 G0 X0 Y0
N20 R1=10 XR1
"         ^^^ W0504
N30 R2=7 R3=R2
"        ^^^^^ W0504
N40 R4=R1 Y0
N50 R4=1 X-R4
"        ^^^^ W0504
N60 M30

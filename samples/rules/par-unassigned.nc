%45 "PAR-5 once for each parameter, at the first read in the order of execution
N10 G90 G0 X0 Y0
N20 G71 L100
N30 XR1 YR2
N40 XR3
"   ^^^ W0503
N50 G91 X5 "no follow-up: X depends on R3"
N60 M30
N100 G79 L100
N110 XR1
"    ^^^ W0503
N120 R2=7 "PAR-6 assigned here, read in N30"
N130 G70

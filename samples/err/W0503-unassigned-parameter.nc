%503 "Parametry ze stroje
"PAR-5 read before the program assigns them; once for each parameter
N10 G90 G0 X0 Y0 S800 M3
N20 G1 XR10 F200
"      ^^^^ W0503
N30 Y5 XR10
N40 R12=R11
"   ^^^^^^^ W0503
N50 Y10 FR11
N60 R13=5
N70 XR13
N80 M30

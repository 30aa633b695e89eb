%134 "MFN-4 after a function that moves the machine all positions are unknown
N10 G90 G0 X0 Y0 Z0
N20 M60
N30 G91 X5
N40 T1 M6
N50 X5
"   ^^ W0605
N60 Y5
"   ^^ W0605
N70 X5 Y5
N80 G90 Z50
N90 G91 Z5
N100 M30

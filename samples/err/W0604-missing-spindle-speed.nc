%604 "Posuv na otacku bez otacek
"TEC-3 once per program
N10 G90 G0 X0 Z0
N20 G1 G95 X50 F0.2
"   ^^ W0604
N30 Z-50
N40 M30

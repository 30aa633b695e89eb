%157 "TEC-3 TEC-7 working motion in G95 and G96, and a thread, need S
N10 G90 G0 X0 Z0
N20 G1 X5 F100 "not in G94"
N30 G33 Z-10 K1 G95
"   ^^^ W0604
"   ^^^ W0619
N40 G1 G96 X10 F100 "once per program"
N50 G97 X15 "once per program"
N60 M30

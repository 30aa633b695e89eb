%631 "tool change and end under a correction"
"TEC-9
N10 G0 X0 Y-10 F100 D1 T1
N20 G41 G1 Y0
N30 M6
"   ^^ W0625
N40 G1 X50
N50 M30
"   ^^^ W0625

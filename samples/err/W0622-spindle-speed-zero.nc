%622 "the spindle is switched on and does not turn"
"TEC-8 S0, at the first working motion
N10 G0 X0 Y0 F100 S0 M3
N20 G1 X50
"   ^^ W0622
N30 G1 X60
N40 M30

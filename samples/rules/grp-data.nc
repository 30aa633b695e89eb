%116 "GRP-4 the axis words are data, nothing moves: no feed is missed
N10 G90 G1
N20 G92 G54 X100 Y50.5
N30 G92 D5 Z120.5
N40 G93 X10 Y10
N50 G35 X0
N60 G36 X0 Y0 I1 J1 K1
N70 G37 X5 Y5
N80 G38 X1 I0.5 J2 K3
N90 G39 C30
N100 G31 X1 I0.5
N110 G34
N120 G0 G91 X5 Y5 "after G93 the named axes stand at the programmed coordinates"
N130 M30

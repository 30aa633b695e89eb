"! dialect=cnc8x9
%161 "TEC-6 M37 reduces the feed to a hundredth until M36 or the end
N10 G90 G0 X0 F1600 M37
N20 G1 X10
N30 M36 X20
N40 M37 M30

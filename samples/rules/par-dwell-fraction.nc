%60 "GRP-5 PAR-3 a dwell by parameter takes a point, but no fraction"
N10 R1=4 G90 G0 X0 Y0
N20 GR1 Q5.
N30 GR1 Q5.5
"        ^^^ E0304
N40 GR1 Q5.0004
"        ^^^^^^ E0304
N50 M30

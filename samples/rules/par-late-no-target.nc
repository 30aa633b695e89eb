%62 "FLW-7 a call from a parameter: without L
N10 R1=71 G90 G0 X0 Y0
N20 GR1
"   ^^^ E0401
N30 M30

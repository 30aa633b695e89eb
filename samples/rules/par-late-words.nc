%59 "FLW-7 GRP-5 PAR-3 what a function from a parameter needs
N10 R1=4 R2=71 R3=90 G90 G0 X0 Y0
N20 GR3 Q5
"       ^^ W0403
N30 GR3 L5
"       ^^ W0402
N40 GR1
"   ^^^ E0411
N50 GR1 Q0 "the dwell may be 0"
N55 GR2 GR1 L100 Q2
"                ^^ W0412
N60 GR2 L100 Q0 "repeats may not"
"             ^ E0302
N80 G71 L100
N90 M30
N100 G79 L100
N110 G70

%613 "Sroubovice bez G09
"MOT-3 three axis words: the third makes a helix
N10 G90 G0 X0 Y0 Z0
N20 G2 X20 Y0 Z-5 I10 F200
"   ^^ W0613
N30 G9
N40 G2 X0 Y0 Z-10 I-10
N50 G98
N60 M30

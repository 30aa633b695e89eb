%616 "Soustruh nema osu Y
"GRP-2 a plane that the machine does not have, executed or not
N10 G90 G0 X50 Z2 G17
"                 ^^^ W0616
N20 G18 X40
"   ^^^ W0616
N30 G19
N40 G71 L100
N50 M30
N100 G79 L100
N110 G73 L130
N120 G14
"    ^^^ W0616
N130 G70

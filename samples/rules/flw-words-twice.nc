%102 "BLK-3 FLW-7 of L and Q written twice the first one counts
N10 G90 G0 X0 Y0
N20 Q5 Q6
"   ^^ W0403
"      ^^ E0306
N30 L5 L6
"   ^^ W0402
"      ^^ E0306
N40 G71 L100
N50 M30
N100 G79 L100
N110 G0 X5
N120 G70 Q5 "G70 takes no Q"
"        ^^ W0403

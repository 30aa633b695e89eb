%182 "FLW-7 the target before the function, the next block behind it on the line
N10 G90 G0 X0 L20 G73 N20 "hole"
N30 X1 L40 G71 N35 "the next block"
N37 M30
N40 G79 L40
N50 G70

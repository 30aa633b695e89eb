%200 "a call that cannot be read may call any subprogram
N10 G71
"   ^^^ E0401
N20 M30
N30 G79 L100
N40 G70

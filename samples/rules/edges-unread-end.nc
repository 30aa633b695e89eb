%198 "an end that cannot be read is not missed
N10 X5
N20 M-30
"    ^^^ E0305

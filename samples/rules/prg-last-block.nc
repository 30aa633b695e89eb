%1 "posledni blok podprogramu ma i jina slova (PRG-3)"
N10 G71 L5
N20 G71 L6
N30 M30
N40 G79 L5
N50 G04 Q50 P3 G70
N60 G79 L6
N70 G70 Q5 P3
"       ^^ W0403

%114 "Komentar bez koncovych uvozovek"
"LEX-6 words at the end of a comment that no quote closes"
N10 G90 G0 X0 Y0 S800 M3
N20 G1 Z-2 F100 "zanoreni N30 X50
"                         ^^^^^^^ W0114
N40 X-10 "prejezd Y20"
N50 M30

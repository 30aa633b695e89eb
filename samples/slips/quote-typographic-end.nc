%1 "A typographic quote closes no comment: one word behind it is swallowed"
N10 G54 G17 G90 G40 T1 M06
N20 G00 X0 Y0 Z50 S800 M03 M08
N30 Z100 "RETRACT“ M09
"                  ^^^ W0114
N40 M30

%1022 "LEX-11 the R of a parameter in lower case
N10 G90 G0 X0 Y0 R5=1
N20 Yr5
"    ^ W0108
N30 M30

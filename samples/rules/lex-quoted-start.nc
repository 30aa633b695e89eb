"LEX-1 the first one counts even between quotes %1002 "title
N10 G90 G0 X0 Y0
N20 M30

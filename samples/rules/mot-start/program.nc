%182 "MOT-2 MOT-3 the start is configured, I goes by the plane's name
N10 G19 G2 X20 Z15 I10 J0 F100
N20 G17 G91 X1
"           ^^ E0602
N30 M30

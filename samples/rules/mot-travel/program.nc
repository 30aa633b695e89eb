%181 "MOT-1 the travel of the axes
N10 G90 G0 X100 Z0 F100
N20 X100.001
"    ^^^^^^^ W0621
N30 G91 X-200
"        ^^^^ W0621
N40 G90 G74 X100
N50 X101 "a diameter
"    ^^^ W0621
N60 G75 X50
N70 G71 L100 Q3
N80 R1=-5 X50
N90 ZR1
"   ^^^ W0621
N100 G92 G54 X500 "data
N110 M30
N200 G79 L100
N210 X-50 "once for each place
"     ^^^ W0621
N220 G70

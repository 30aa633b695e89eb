%27 "BLK-1 lines without a block number
N10 G90 G0 X0 Y0
G71 L100
"@ 3:1-3:4 W0221
N20 X5
N30 X10 "W0213 alone for a line that begins with a slash
 / Y10
"^ W0213
N40 X15
"a comment" Y15
"           ^^^ W0221
N50 X20
N60 X25
N70 X30
N80 X35
N90 X40 N91 Y40 "two blocks on one line are one line
N92 X45
N93 X50
N94 X55
N95 G71 L200
N99 M30
N100 G79 L100 "four of five lines begin with N: fewer than five
N110 X1
Y1
N120 X2
N130 G70
N200 G79 L200 "fewer than eight of ten
N210 X1
Y1
N220 X2
Y2
N230 X3
Y3
N240 G70

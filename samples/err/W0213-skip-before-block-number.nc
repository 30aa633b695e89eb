%213 "Lomitko pred N
"BLK-6 a slash before N belongs to the block before it
N10 G90 G0 X0 Y0
 / N20 G0 X5
"^ W0213
N30 G0 Y5
 /N40 X10
"^ W0213
N50 G0 X15 / N60 Y15
"          ^ W0213
N70 / G0 X0
N80 G0 Y0 /
N90 M30

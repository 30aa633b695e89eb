%180 "MOT-8 changes of origin
N10 G90 G0 X0 Y0 F100 D1
N20 G54
N30 G2 X20 I10
"   ^^ W0610
N40 G2 X0 I-10
N50 G54 "the same again"
N60 G2 X20 I10
N70 G58 G0 X0 Y0
N80 G2 X20 I10 "back from G58 to G54"
"   ^^ W0610
N90 G3 G55 X0 I-10 "the block that changes it and moves"
"   ^^ W0610
N100 G3 X20 I10
N110 &1
N120 G2 X0 I-10
"    ^^ W0610
N130 D2
N140 G2 X20 I10
"    ^^ W0610
N150 D2 "the same number"
N160 G2 X0 I-10
N170 &0
N180 G2 X20 I10
"    ^^ W0610
N190 D3 "no digit of & is other than 0"
N200 G2 X0 I-10
N210 &0000
N220 G2 X20 I10
N230 G92 G55 X100
N240 G2 X0 I-10
"    ^^ W0610
N250 G35 X0
N260 G3 X20 I10
"    ^^ W0610
N270 G34
N280 G0 X20 Y0 "any motion ends the state"
N290 G3 X0 I-10
N300 G93 X0 Y0
N310 X20 I10 "the tool stands where G93 says"
N312 G93 G55 X0
N314 G2 X0 Y0 I10
"    ^^ W0610
N320 M30

%1006 "LEX-6 N10 X5
"            ^^^^^^ W0114
"LEX-6 a comment that no quote closes, and that ends in words; this title too"
N10 G90 G0 X0 Y0 "najeti N20 X50
"                        ^^^^^^^ W0114
N30 X1 "N40X50Y20
"       ^^^^^^^^^ W0114
N50 X2 "frezovat n60 g1x5
"                ^^^^^^^^ W0114
N70 X3 "prejezd XR10 Y-R11 R12=5
"               ^^^^^^^^^^^^^^^^ W0114
N80 X4 "prejezd X  10.5 Y -3
"               ^^^^^^^^^^^^ W0114
N90 X5 "one word is a remark: viz N30
N100 X6 "none of them N, G, M or an axis: T5 D1
N110 X7 "words before the end: X5 Y6 konec
N120 X8 "no words: KAPSA20X30
N130 X9 "closed: X5 Y6"
N140 X5 "not words: E5 O7 X Y
N142 X5 "posuv a N143 X50
"                ^^^^^^^^ W0114
N144 X5 "odjezd v X5 Y6
"                 ^^^^^ W0114
N145 X5 "k R1=5 X5
"          ^^^^^^^ W0114
N146 X5 "k N147 X5 *
"          ^^^^^^^^^ W0114
N148 X5 "n N149 X1 Y2
"          ^^^^^^^^^^ W0114
N1480 X1"0 Y2
"        ^^^^ W0114
N1482 Y3"0
"        ^ W0114
N1484 X1"5 mm is a remark
N1486 T5"12
N1488"2
N1490 X1"0 Y5 "D16"
"        ^^^^^ W0114
N1492 X1 D16"
"           ^ W0114
N1494 X1 T2" M06
"           ^^^^ W0114
N1496 T5"D16
N150 M30
* "after the end N160 X5

%811 "EQU-3 an arc smaller than the correction; a step narrower than the tool
N10 G17 G90 G0 X0 Y-20 D7 F200 S800 M3
N20 G41 G1 Y0
N30 X30
N40 Y20
N50 G3 X24 I-3
"@ 6:1-6:4 W0811
N60 G1 Y8
N70 G40 Y-20
N80 G42 X-10
N90 X-60
N100 Y-18 "lower than the radius
"@ 12:1-12:5 W0811
N110 X-100
N120 G40 Y-50
N130 G41 X-60
N140 X0
N150 Y-48 "two inner corners, 2 mm apart
"@ 18:1-18:5 W0811
N160 X-40
N170 Y-10
N180 G40 X0
N190 M30

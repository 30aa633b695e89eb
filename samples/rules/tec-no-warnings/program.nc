%640 "what W0622 to W0627 do not warn of"
"TEC-8 S0 at rest and in rapid, S before the first motion, defined M
N10 G54 G17 G90 G40 S0
N20 T1 D1 M06
N30 G00 X0 Y0 Z5 M03
N40 S1000 M37
N50 G01 X5 F100 M36
N60 M70
"TEC-9 on and off along a line, an arc between, G40 between the sides
N70 G41 G01 X10
N80 G03 X20 Y10 I0 J10
N90 G01 Y20
N100 G40 X15
N110 G42 X10
N120 G40 X5
"TEC-10 the axis of the tool by G01, in the plane under G00; M06 after G80
N130 G81 G01 X30 Y10 Z4
N140 G00 X40
N150 G80
N160 T2 D2 M06
N170 G18 G81 Y50 Z3
N180 G80 G17
N190 M05
N200 M30

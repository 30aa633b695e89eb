%1001 "PLATE 100 x 60 x 20, CONTOUR AND 4 HOLES"
"Aluminium, clamps outside the contour"
"G54: lower left corner, top face"
N10 G54 G17 G90 G94 G40 G80 "a known state"

"--- T1 MILL D16, CORRECTION D1 ---"
N100 T1 M06
N110 S3200 M03 M08 "speed and coolant"
N120 G00 X-30 Y-30 "beside the part"
N130 Z5 D1 &0010 "length correction in Z"
N140 G01 Z-20 F300
N150 G71 L100 "contour: subprogram L100"
N160 G00 Z100 M09
N170 M05

"--- T2 DRILL D8.5, CORRECTION D2 ---"
N200 T2 M06
N210 S1800 M03 M08
N220 G00 X20 Y15
N230 Z5 D2 "correction of the drill"
N240 R10=-25 R11=150 "depth and feed for L8100"
N250 G81 X20 Y15 "1st hole: G81 calls L8100"
N260 X80
N270 Y45
N280 X20
N290 G80 Z100 M09 "drilling off, retract"
N300 M30 "end of program"

N1000 G79 L100 "CONTOUR, FROM X-30 Y-30"
N1010 G41 G01 X0 Y-20 F400 "tool on the left, D1; straight"
N1020 Y60
N1030 X90
N1040 G02 X100 Y50 I0 J-10 "corner R10, centre X90 Y50"
N1050 G01 Y0
N1060 X-20
N1070 G40 X-30 Y-30 "correction off, straight"
N1080 G70

%1 "jine pismeno misto N v bloku, kam vede skok"
"BLK-1 FLW-5 the line that lacks its number is the one fault
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 G1 X5 Z-2 F300
Z50 X20
"@ 7:1-7:4 E0306
N60 Y20
N70 Y30
N80 G73 L50 Q2
N90 M30

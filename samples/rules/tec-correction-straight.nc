%630 "a correction that begins and ends on straight motions"
"TEC-9 G41 that is in force already changes nothing
N10 G0 X0 Y-10 F100 D1
N20 G41 G1 Y0
N30 G2 X20 Y0 I10
N40 G41 G2 X40 Y0 I10
N50 G1 X50
N60 G40 Y-10
N70 G2 X60 Y-10 I5
N80 G42
N90 G1 X70
N100 G2 X80 Y-10 I5
N110 G40 G1 X90
N120 M30

%3022 "Posuv na otacku mimo rozsah
"TEC-1 in G95 the feed is 0.001 to 99.999 mm per revolution
N10 G90 G0 X0 Y0 S800 M3
N20 G1 X5 F100
N30 G95
N40 X10 F120
"        ^^^ E0302
N50 G94
N60 X20 F0.5
"        ^^^ E0302
N70 X25 F0120.50
N80 M30

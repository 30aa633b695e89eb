%1 "cislice za / po mezere (LEX-10)"
N10 G90 G00 X0 Y0/ 1
N20 X5/ 1 Y7 /2
N30 S500/ 2 M03/	1
N40 M30

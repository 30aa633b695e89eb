%1 "cislice za / po mezere (LEX-10)"
N10 G90 G00 X0 Y0/ 1
N20 X5/ 1 Y7
N30 S500/ 2 M03
N40 M08/	1
N50 M30

"@ 5:81-5:82 E0109
"! dialect=cnc8x6
%1024 "LEX-7 on CNC8x6 an error, and the program is executed
N10 G90 G0 X0 Y0
N20 X5 "eighty-one xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx
N30 G1 X10
"   ^^ W0601
N40 M30

"@ 4:81-4:82 E0109
%1023 "LEX-7 on CNC872 a warning: the program is executed
N10 G90 G0 X0 Y0
N20 X5 "eighty-one xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx
N30 G1 X10
"   ^^ W0601
N40 M30

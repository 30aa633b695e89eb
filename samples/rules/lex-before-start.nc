LEX-1: whatever stands here is ignored: X1.2.3 ; ( ) # "unclosed
and X36,12 XO E5 ž š č, also a line longer than eighty characters: xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx
%1001 "LEX-1 here the program begins, and a % in a comment is no second start
N10 G90 G0 X0 Y0 "50 % done"
N20 M30

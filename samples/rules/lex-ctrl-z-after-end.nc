%1017 "LEX-9 and after the asterisk
N10 G90 G0 X0 Y0
N20 M30
*

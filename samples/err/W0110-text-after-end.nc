%110 "Zbytek po konci
"LEX-9 after the asterisk nothing is read
N10 G90 G0 X0 Y0
N20 M30
*
"komentar za koncem nevadi
 5
"^ W0110

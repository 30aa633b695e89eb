%1 "PAR-8 nine digits in place of eight
N10 G54 G90 G00 X0 Y0
N20 R1=5 R2=7
N30 G26 R5=015043500
"          ^^^^^^^^^ E0508
N40 M30

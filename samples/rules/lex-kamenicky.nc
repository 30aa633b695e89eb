"! args=--encoding=kamenicky
%1010 "LEX-13 p©¡ruba, Kamenick˜
N10 "Obr bˆn¡" G90 G0 G1 X0
"                     ^^ E0307
N20 X5 ¨‡ Y5
"      ^^ E0101
N30 M30

"! args=--encoding=iso-8859-2
%1009 "LEX-13 pøíruba, kódování ISO 8859-2
N10 "Obrábìní" G90 G0 G1 X0
"                     ^^ E0307
N20 X5 ¹è Y5
"      ^^ E0101
N30 M30

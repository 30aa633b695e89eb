"! args=--encoding=windows-1250
%1008 "LEX-13 pøíruba, kódování Windows-1250
N10 "Obrábìní" G90 G0 G1 X0
"                     ^^ E0307
N20 „luouèkı" X5 X6
"   ^ E0105
"                  ^^ E0306
N30 M30

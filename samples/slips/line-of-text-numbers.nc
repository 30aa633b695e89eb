%1 "veta, ktere chybi uvozovka, je jedna zavada, at zacina jakkoli
R90, R91 (odjezd a najezd v Z) jsou v tabulce stroje
"@ 2:1-2:53 E0111
N10 G54 G90 G0 X0 Y0 Z50
N20 M30

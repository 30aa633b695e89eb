"@ 1:1-1:1 E0201
"Deska 60x40, chybi cislo programu
N10 G90 G0 X0 Y0
N20 G1 X60 F200
N30 Y40
N40 M30
*

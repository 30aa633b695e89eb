%1 "za poznamkou chybi uvozovka: poznamka spolkla prirazeni"
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
"hloubka a posuv N40 R10=-5 R11=200
"                ^^^^^^^^^^^^^^^^^^ W0114
N50 G1 ZR10 FR11
N60 G0 Z50
N70 M30

%1 "uvozovka pred G27: vysledek vypoctu neni znam"
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3 R10=2 R11=3
N40 "G27 R5=2101113
"    ^^^^^^^^^^^^^^ W0114
N50 G1 ZR13 F200
N60 G0 Z50
N70 M30

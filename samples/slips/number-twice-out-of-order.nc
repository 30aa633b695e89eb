%1 "cislo bloku dvakrat: to, ktere nezapada, je to chybne
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N50 S1200 M3
"@ 4:1-4:4 E0204
N40 G1 X40 F300
N50 Y40
N60 M30

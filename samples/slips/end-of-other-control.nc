%1 "procento na konci souboru"
N10 G54 G90 G0 X0 Y0 Z50
N90 M30
%
"@ 4:1-4:2 E0202

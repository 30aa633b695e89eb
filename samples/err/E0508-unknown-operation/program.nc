"@ 7:23-7:32 E0508
%508 "Neznama operace
"PAR-9 only what the configuration names
N10 R10=5 R11=2
N20 G26 R5=50101112
"          ^^^^^^^^ E0508
N30 G27 R5=1101112 R6=-77101113
N40 G26 R5=50999999 "E0507 comes after E0508, that once for each code
N50 M30

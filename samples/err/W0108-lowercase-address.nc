%108 "Mala pismena
"LEX-11 one warning for a file, at the first
N10 G90 G0 X0 Y0 S800 M3
N20 g1 x50 f200
"   ^ W0108
N30 y40
n40 x0
N50 g0 z50
N60 m30

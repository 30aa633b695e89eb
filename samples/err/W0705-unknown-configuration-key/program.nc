%705 "Preklepy v konfiguraci
"the dialect stays cnc872: M100 is in range
N10 G90 G0 X0 Y0 M100
"                ^^^^ W0623
N20 M30

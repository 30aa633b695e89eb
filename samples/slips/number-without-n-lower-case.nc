%1 "mala pismena
"! args=-A W0108
n10 g54 g90 g0 x0 y0 z50
n20 t1 m6
n30 s1200 m3
40 g1 y20 f300
"@ 6:1-6:3 E0106
n50 g0 z50
n90 m30

%1 "adresy malymi pismeny"
n10 g54 g90 g0 x0 y0 z50
"@ 2:1-2:2 W0108
n20 s1200 m3
n30 g1 x5 f300
n90 m30

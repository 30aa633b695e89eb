%1 "veta, kterou v pulce zavrela uvozovka
" rada 1 + 3 dulky", celkem 3 rady = 12 dulku, a to dvakrat
"@ 2:20-2:60 E0111
N10 G54 G90 G0 X0 Y0 Z50
N20 M30

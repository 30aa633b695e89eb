%409 "Prilis hluboke volani
"FLW-2 two open calls are allowed here
N10 G90 G0 X0 Y0
N20 G72 L9001
N30 M30

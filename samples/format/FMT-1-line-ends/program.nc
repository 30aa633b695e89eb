%1
N10 G0 "pı¡ruba"  X1
N20 M30

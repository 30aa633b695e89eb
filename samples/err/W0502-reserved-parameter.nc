%502 "Vyhrazeny parametr
"R95 is reserved for control functions
N10 G90 G0 X0 Y0
N20 R95=1
"   ^^^^^ W0502
N30 R94=1
N40 M30

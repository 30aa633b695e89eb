%217 "Dva soubory jednoho makrocyklu
"PRG-6 L9001 and L09001.nc are the same macrocycle
N10 G90 G0 X0 Y0
N20 G72 L9001
"        ^^^^ E0217
N30 M30

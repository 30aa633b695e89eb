%1 "hvezdicka v makrocyklu"
"LEX-9 the missing end of the macrocycle says what the star cuts off
N10 G54 G90 G0 X0 Y0 Z50 T1
N15 M6
N17 S1200 M3 F300
N20 G72 L9208
N30 M30

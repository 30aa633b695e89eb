%505 "Reference, jak je zvykem jinde
"PAR-7 G28 is arithmetic; MOT-7 the reference point is approached by G30
N10 G90 G0 X0 Y0 Z50
N20 G28 Z0
"   ^^^ E0505
N30 M30

%1 "strednik pohlti prirazeni pro makrocyklus
N10 G54 G90 G0 X0 Y0 Z50
N20 S7;00 M3 F80 R40=4
"     ^^^^^^^^^^^^^^^^ E0101
N30 G72 L9002
N40 M30

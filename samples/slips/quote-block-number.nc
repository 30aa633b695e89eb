%1 "zapomenute uvozovky pred textem s cislem bloku"
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 G73 L60 Q1     skok vpred: preskoci N50"
"                  ^^^^^^^^^^^^^^^^^^^^^^^^ E0111
N50 G1 X10 F200
N60 G0 Z50
N70 M30

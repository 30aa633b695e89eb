# Behind T, F, S and the like stand the values that the program has already, the most frequent first; behind an arc's function
# I and J come before what is no part of it.
=== open a.nc
%1
N10 T1 M06
N20 G90 G00 X0 Y0 S1200 M03
N30 G01 X10 F200
N40 X20 F350.5
N50 X30 F200
N60 T12 M06
N70 F‹f›
N80 T1‹t›
N90 X50
N100 M30
=== request textDocument/completion a.nc@f
=== answer
=== request textDocument/completion a.nc@t
=== answer

%312 "Delkove korekce
"table of addresses: four digits, each 0, 1 or 2
N10 G90 G0 X0 Y0 &1234
"                 ^^^^ E0312
N20 &3 D1
"    ^ E0312
N30 &10000 D2
"    ^^^^^ E0312
N40 &0012 X5
N50 &0 X10
N60 M30

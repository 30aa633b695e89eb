%116 "Slova, ktera zde znamenaji, co jinde ne, a jsou tak minena
"§13 an origin at G53, tables with F, an own M98, T with D
N10 G92 G53 X0 Y0 Z0
N20 G92 G54 X100 Y50 Z20 F100 S500 M03
N30 G92 D5 X12.5 Z3 F100
N40 G92 X0 Y0 Z0 F100
N50 G54 T0101 D1 M06
N60 M98 P10
N70 G00 X0 Y0 Z5
N80 G01 Z-2
N90 G00 Z50
N100 G53 Z50
N110 X0 Y0
N120 G01 Z-2
N130 G97 S500 F0.2 X5
"the spindle turns until the motion of the block with M30 has ended
N140 G94 S900 F100
N150 G01 X9 M30

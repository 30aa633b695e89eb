%221 "Zapomenute cislo bloku
"BLK-1 nearly every line begins with N; others belong to the block above
N10 G90 G0 X0 Y0 S800 M3
N20 G1 F200 X40
N40 X50
Y50
"@ 6:1-6:4 W0221
N70 G0 Z100 M09
M05
"@ 9:1-9:4 W0221
N80 X0
N90 Y0
  F500 "BLK-1 a line that begins with a blank is meant to continue the block
N92 Z5
N95 X10
N97 X20
N98 X30
N99 X40
N100 M30

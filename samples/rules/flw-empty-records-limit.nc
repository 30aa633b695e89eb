"@ 6:1-6:4 W0214
"@ 7:1-7:4 W0214
"! args=--max-blocks=3
%95 "FLW-8 an empty block has a record
N10 G90 G0 X0 Y0
N20
N30
 N40 M30
"^^^ E0410

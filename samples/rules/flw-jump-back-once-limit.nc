"! args=--max-blocks=5
%81 "FLW-3 without Q a backward jump is taken once: six records
N10 G90 G0 X0 Y0
N20 X5
N30 G73 L20
 N40 M30
"^^^ E0410

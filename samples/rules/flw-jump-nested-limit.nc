"! args=--max-blocks=16
%84 "FLW-4 the inner loop runs in full in every pass of the outer: 17 records
N10 G90 G0 X0 Y0
N20 X5
N30 G73 L20 Q1
N40 G73 L20 Q2
 N50 M30
"^^^ E0410

"! args=--max-blocks=2
%82 "FLW-3 without Q a forward jump is taken always: N30 is never executed
N10 G90 G0 X0 Y0
N20 G73 L40
N30 G1 X5
 N40 M30
"^^^ E0410

"! args=--max-blocks=9
%80 "FLW-3 FLW-8 backward with Q3 the stretch runs four times: ten records
N10 G90 G0 X0 Y0
N20 X5
N30 G73 L20 Q3
 N40 M30
"^^^ E0410

"! args=--max-blocks=5
%410 "Prilis mnoho bloku
"FLW-9 with a limit of five, five records are written
N10 G90 G0 X0 Y0
 N20 G0 X5
"^^^ E0410
N30 G73 L20 Q100
N40 M30

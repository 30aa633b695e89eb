"! args=--block-skip --max-blocks=3
%96 "BLK-6 FLW-8 a skipped block is not executed and has no record
N10 G90 G0 X0 Y0
N20 / X5
N30 / G73 L10 Q100
N40 X6
N50 M30

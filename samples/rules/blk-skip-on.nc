"! args=--block-skip
%28 "BLK-6 with block skip none of these is executed: no feed is missed
N10 G90 G0 X0 Y0
N20 / G1 X5
N30 G1 X6 /
N40 G1 X7
 / N50 G0 X8
"^ W0213
N60 M30

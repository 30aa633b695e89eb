%1 "ridici slovo s desetinnou teckou
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 R10=5 R11=2
N50 G26 R5=1.101110
"          ^^^^^^^^ E0507
N60 G1 XR10 F300
N70 M30

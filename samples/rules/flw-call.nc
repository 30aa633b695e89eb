"! args=--max-blocks=12
%90 "FLW-1 FLW-8 the call comes at the end; G79 and G70 have records
N10 G90 G0 X0 Y0
N20 G71 L100 Q3 R1=5 "R1 is assigned before the call"
N30 M30
N100 G79 L100
N110 XR1
N120 G70

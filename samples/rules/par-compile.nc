"! compile
%50 "PAR-5 compile needs the value
N10 G90 G0 X0 Y0
N20 XR10
"   ^^^^ W0503
N30 M30

"! args=--param R10=5
%48 "PAR-5 given on the command line
N10 G90 G0 XR10 Y0
N20 M30

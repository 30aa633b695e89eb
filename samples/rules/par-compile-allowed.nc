"! compile
"! args=-A unassigned-parameter
%51 "PAR-5 A cannot silence it in compile
N10 G90 G0 X0 Y0
N20 XR10
"   ^^^^ W0503
N30 M30

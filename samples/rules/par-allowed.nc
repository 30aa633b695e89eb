"! args=-A unassigned-parameter
%52 "PAR-5 in check it can
N10 G90 G0 X0 Y0
N20 XR10
N30 M30

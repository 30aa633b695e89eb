%135 "MFN-4 TEC-4 without configuration M06 moves nothing; T0 is legal
N10 G90 G0 X0 Y0 T0
N20 T12 M6
N30 G91 X5 Y5
N40 M06
N50 X5
N60 M30

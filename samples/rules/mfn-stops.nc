"! args=--optional-stop
%136 "MFN-6 MFN-7 MFN-8 stops and ends change groups in the record, nothing here
N10 G90 G0 X0 Y0 S800 M3 M8
N20 G1 X5 F100
N30 M0
N40 X10
N50 M01
N60 X15
N70 M00 M4 M7
N80 M48 M10
N90 M5 M9 M30

%140 "MFN-10 a machine without M19
N10 G90 G0 X0 Y0
N20 S100 M19
"        ^^^ E0608
N30 M5
N40 M019
"   ^^^^ E0608
N50 M30

%608 "Orientovany stop
"MFN-10 this machine has no M19
N10 G90 G0 X0 Y0 S800 M3
N20 M19
"   ^^^ E0608
N30 M30

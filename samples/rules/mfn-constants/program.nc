%133 "MFN-5 R56 to R59 give groups 10 to 13
N10 G90 G0 X0 Y0
N20 M91 M94
"       ^^^ E0308
N30 M95 M96
"       ^^^ E0308
N40 M21 M24
"       ^^^ E0308
N50 M91 M95 M97 M21 M20
N60 M97 M98 "00 names nothing: M98 stays in group 14"
N70 M20 M98
"       ^^^ E0308
N80 M30

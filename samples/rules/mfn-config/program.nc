%132 "MFN-1 MFN-2 MFN-3 MFN-4 groups by configuration
N10 G90 G0 X0 Y0
N20 M36 M95
"       ^^^ E0308
N30 M91 M92
"       ^^^ E0308
N40 M8 M93 "a new function in a standard group"
"      ^^^ E0308
N50 M6 T1 M60 "the standard group when none is given"
"         ^^^ E0308
N60 M100 M20 "14 for the others"
"        ^^^ W0623
"        ^^^ E0308
N70 M95 M91 M93 M100 M6
N80 M36 M20
N90 M30

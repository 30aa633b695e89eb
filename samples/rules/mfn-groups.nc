%130 "MFN-1 two functions of one group, CNC872
N10 G90 G0 X0 Y0 S800
N20 M0 M1
"      ^^ E0308
N30 M3 M4
"      ^^ E0308
N40 M5 M19
"      ^^^ E0308
N50 M41 M40
"       ^^^ E0308
N60 M36 M37 "MFN-3 not configured: both belong to group 14"
"   ^^^ W0623
"       ^^^ W0623
"       ^^^ E0308
N70 M36 M20
"       ^^^ E0308
N80 M7 M8
"      ^^ E0308
N90 M17 M9
"       ^^ E0308
N100 M50 M53
"        ^^^ E0308
N110 M51 M52
"        ^^^ E0308
N120 M10 M11
"        ^^^ E0308
N130 M48 M49
"        ^^^ E0308
N140 M6 T1 M60
"          ^^^ E0308
N150 M20 M99
"        ^^^ E0308
N160 M91 M100
"        ^^^^ E0308
N170 M3 M03
"       ^^^ E0308
N180 M3 M41 M8 M50 M10 M48 M6 M20 M0 "one of each group"
N190 M30 M2
"        ^^ E0308

"! dialect=cnc8x9
%131 "MFN-1 MFN-5 two functions of one group, CNC8x9
N10 G90 G0 X0 Y0 S800
N20 M36 M37
"       ^^^ E0308
N30 M36 M20 "group 4 and group 14"
N40 M20 M99
"       ^^^ E0308
N50 M91 M92 "no machine constants: group 14"
"       ^^^ E0308
N60 M3 M41 M37 M8 M50 M10 M48 M6 M20 M0 "ten words, ten groups"
"                             ^^ W0620
N70 M30

"! dialect=cnc8x9
%190 "options win over the project file
N10 G90 G0 X0 Y0
N20 M100 X5
"    ^^^ E0302
N30 M30

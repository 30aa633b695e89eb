%191 "the dialect of the project file
N10 G90 G0 X0 Y0
N20 M100 X5
"    ^^^ E0302
N30 H1.5 X6
"    ^^^ E0304
N40 M30

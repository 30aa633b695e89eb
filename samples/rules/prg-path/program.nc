%71 "PRG-6 the path replaces the program's folder, without its subfolders
N10 G90 G0 X0 Y0
N20 G72 L9001
N30 G72 L9002
N40 G72 L9003
"        ^^^^ E0405
N50 G72 L9004
"        ^^^^ E0405
N60 G72 L9005 "in both folders"
"        ^^^^ E0217
N70 M30

%67 "PRG-4 a subprogram is called from its own file only
N10 G90 G0 X0 Y0
N20 G72 L9060
N30 G71 L100
N40 M30
N100 G79 L100
N110 G70

%73 "LEX-1 a percent sign within a macrocycle
N10 G90 G0 X0 Y0
N20 G72 L9083
N30 M30

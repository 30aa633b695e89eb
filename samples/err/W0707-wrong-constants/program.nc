%1 "Konstanty check nezastavi
N10 G90 G0 X0 Y0
N20 M30

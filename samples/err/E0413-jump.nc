%4131 "Skok v koncovem bloku
N10 G90 G0 X0 Y0
N20 G0 X5
N30 M02 G73 L10 Q3
"       ^^^ E0413

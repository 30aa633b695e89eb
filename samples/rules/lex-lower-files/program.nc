%1025 "LEX-11 one warning for each file
N10 G90 G0 X0 Y0
N20 g72 l9010
"   ^ W0108
n30 m30

%1 "druhy program za hvezdickou"
N10 G54 G90 G0 X0 Y0 Z50
N90 M30
*
%2
"@ 5:1-5:3 W0110
N10 G0 X5
N20 M30
*

%1 "jine pismeno misto N pod G79"
"PRG-3 the number of the block is the one fault
N10 G54 G90 G0 X0 Y0 Z50
N20 G71 L100
N30 M30
N100 G79 L100
M110 X5
"@ 7:1-7:5 E0208
N120 G70

%3101 "Dvanact G v bloku
"BLK-4 at most 11 G words
N10 R10=1 R11=2
N20 G1 G17 G98 G40 G26 G54 G94 G71 G80 G90 G75 G34 L100 X5 F100
"                                              ^^^ E0310
 R5=01101112
N30 M30
N100 G79 L100
N110 G0 Y5
N120 G70

%3102 "Jedenact M v bloku
"BLK-4 at most 10 M words
N10 G90 G0 X0 Y0
N20 S100 M0 M3 M41 M36 M8 M50 M10 M48 M6 M91 M20
"                                     ^^ W0620
"                                            ^^^ E0310
N30 M30

%1006 "LEX-13 columns are characters
N10 "Obrábění příruby – 1. strana" G90 G0 G1 X0
"                                         ^^ E0307
N20 "😀 jeden znak" X5 X6
"                     ^^ E0306
N30 G0 X1 "ž" X2
"             ^^ E0306
N40 Y5 "LEX-7 příliš žluťoučký kůň úpěl ďábelské ódy xxxxxxxxxxxxxxxxxxxxxxxxxxx
N50 M30

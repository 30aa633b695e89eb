%202 "Dva programy slepene za sebou
"LEX-1 a second percent sign outside a comment
N10 G90 G0 X0 Y0 "i 100% v komentari je v poradku"
N20 G1 X60 F200
 %203 "Druha deska
"^^^^ E0202
N30 Y40
N40 M30

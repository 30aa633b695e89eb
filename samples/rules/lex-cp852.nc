%1007 "LEX-13 pý¡ruba, k¢dov n¡ CP852
N10 "Obr bØn¡ - druh  strana" G90 G0 G1 X0
"                                    ^^ E0307
N20 "§luœouŸkì k…å" X5 X6
"                      ^^ E0306
N30 X7 ý Y7
"      ^ E0101
N40 M30

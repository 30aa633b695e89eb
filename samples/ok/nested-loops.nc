%14 "VNORENE SKOKY A VOLANI"
" Vnitrni skok N60 se v kazdem pruchodu vnejsiho N90 vykona cely:"
" rada 1 + 3 dulky, celkem 3 rady = 12 dulku, a to dvakrat (N120)."
N10 G54 G17 G90 G94 T7 M06          "Stredici vrtak D4"
N20 S2000 M03 M08
N30 G00 X0 Y0
N40 Z5
N50 G71 L10                         "dulek na miste"
N60 G91 G00 X12 G73 L50 Q3          "4x: dulek, posun o 12 mm"
N70 X-48                            "zpet na zacatek rady"
N80 Y15                             "dalsi rada"
N90 G73 L50 Q2                      "celkem 3 rady"
N100 Y-45                           "zpet na prvni radu"
N110 X100                           "druhy kus vpravo"
N120 G73 L50 Q1
N130 G90 Z100 M09
N140 G73 L160                       "skok vpred bez Q: preskoci N150"
N150 G04 Q500                       "dobeh vretene, jen pri serizovani"
N160 X0 Y0 M05
N170 M30

N500 G79 L10                        "jeden dulek, dvakrat dotknout"
N510 G90 G01 Z-0.8 F120
N520 G00 Z1 G73 L510 Q1
N530 Z5 G70
*

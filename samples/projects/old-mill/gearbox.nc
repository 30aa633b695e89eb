%860012 "SKRIN PREVODOVKY: DVE CELA A OTVOR D120H7"
" Vodorovna vyvrtavacka: W pinola, B stul. Nula: osa otvoru, Z0 = celo."
" Po zapnuti stroje plati G55, strana B ma pocatek G56."
" Chlazeni 1 zapina u tohoto systemu M08, chlazeni 2 M07."
N10  G17 G40 M40 M36
N20  T1 H1 M06                      "Celni hlava D160; H1 podavac vlevo"
N30  G00 Z300 W0
N40  B0
N50  M71 M81 M61                    "zpevnit stul a pinolu, dopravnik"

"--- strana A ---"
N60  S125 M03                       "M40: rozsah 1"
N70  G00 X-180 Y-45
N80  Z0 M08
N90  G01 X180 F160
N100 Y65
N110 X-180
N120 G00 Z300 M09
N130 T2 H1 M06                      "Vyvrtavaci tyc D119.5"
N140 G71 L100
N150 T3 H2 M06                      "Vyvrtavaci tyc D120H7; H2 podavac vpravo"
N160 G71 L200
N170 M01                            "zmerit otvor"
N180 /T3 H2 M06                     "znovu nastaveny nuz, jen podle mereni"
N190 /G71 L200

"--- strana B: stul o 180 stupnu ---"
N200 M72                            "uvolnit stul"
N210 B180
N220 M71 G56
N230 T1 H1 M06
N240 S125 M03
N250 G00 X-180 Y0
N260 Z0 M08
N270 G01 X180 F160
N280 G00 Z300 M09

"--- otvory M12: sest der na D160, vrtani pinolou ---"
N290 T4 P3 M06                      "Vrtak D10.2; P3 maly zasobnik"
N300 S900 M03 M17                   "M40: rozsah 3; obe chlazeni"
N310 M82                            "uvolnit pinolu"
N320 G00 X80 Y0
N330 Z5 G71 L300
N340 X40 Y69.282 G71 L300
N350 X-40 G71 L300
N360 X-80 Y0 G71 L300
N370 X-40 Y-69.282 G71 L300
N380 X40 G71 L300
N390 Z300 M09
N400 M81 M63                        "zpevnit pinolu, dopravnik stop"
N410 B0 M05 M92                     "domazat vedeni"
N420 X0 Y0 M30

"--- L100: otvor hrubovat ---"
N1000 G79 L100
N1010 M41 S140 M03
N1020 G00 X0 Y0
N1030 Z5 M08
N1040 G01 Z-85 F35
N1050 G00 Z300 M09 G70

"--- L200: otvor nacisto, nuz od steny v orientovane poloze ---"
N1100 G79 L200
N1110 M42 S210 M03
N1120 G00 X0 Y0
N1130 Z5 M08
N1140 G01 Z-85 F1600 M37            "16 mm/min"
N1150 G04 Q100 M36
N1160 M19
N1170 G91 G00 Y0.3                  "odskok od steny"
N1180 G90 Z5
N1190 Y0
N1200 Z300 M05 M09
N1210 M40 G70                       "rozsah zase podle S"

"--- L300: jedna dira vysunutim pinoly ---"
N1300 G79 L300
N1310 G01 W12 F110
N1320 G00 W0
N1330 W11.5
N1340 G01 W31
N1350 G04 Q10
N1360 G00 W0 G70
*

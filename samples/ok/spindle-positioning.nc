%1900 "PASTOREK: ZAVIT M20x1.5 A CTYRI DRAZKY"
" Soustruh s polohovanim vretena v ose C, nula G54 na cele."
" Hotovo z predchozi operace: hrdlo D19.85 x 14, telo D30 po zapich"
" v Z-37, stredova dira D6.8 x 22."
" Po M19 je vreteno rotacni osa; F v bloku s C jsou stupne za minutu."
N10 G54 G19 G74 G90 G95 G40
N20 G00 X120 Z150

"=== ZAVIT M20x1.5 na hrdle delky 14 ==="
N30 T5 D5 M06                       "Zavitovy nuz"
N40 S600 M03 F1.5
N50 G00 X24 Z6 M08
N60 X19.4 G71 L100
N70 X18.9 G71 L100
N80 X18.5 G71 L100
N90 X18.25 G71 L100
N100 X18.16 G71 L100
N110 X18.16 G71 L100                "vyjiskrit"
N120 X120 Z150 M09

"=== DRAZKY 4 x 90 stupnu na tele D30, obrazeni nozem sirky 4 ==="
N130 T8 D8 M06                      "Obrazeci nuz"
N140 M05
N150 M19                            "orientovany stop, osa C"
N160 G94 G00 C0
N170 X30 Z-10 M07                   "pred celem tela, nad hrdlem"
N180 G91 G00 X-0.2                  "prisuv 0.1 mm na hloubku"
N190 G90 G01 Z-38 F4000             "pracovni zdvih do zapichu"
N200 G91 X0.6                       "odskok"
N210 G90 G00 Z-10
N220 G91 X-0.6
N230 G73 L180 Q19                   "20 zdvihu, dno na D26"
N240 G90 X30
N250 G91 G01 C90 F7200              "dalsi drazka"
N260 G73 L180 Q3
N270 G90 G00 X60 M09
N280 X120 Z150

"=== ZAVITNIK M8 v ose, reverzace vretena ==="
N290 T9 D9 M06                      "Zavitnik M8 v pouzdre"
N300 G95 S250 M03                   "rusi polohovou vazbu"
N310 G00 X0 Z8 M08
N320 G33 Z-18 K1.25
N330 M05
N340 S250 M04
N350 G33 Z8 K1.25
N360 M05
N370 G00 X120 Z150 M09
N380 M30

"--- L100: jeden pruchod zavitu ---"
N1000 G79 L100
N1010 G33 Z-13 K1.5
N1020 G00 X24
N1030 Z6 G70
*

%6001 "NABOJ: CELO, SEST BOCNICH OTVORU A OBVODOVA DRAZKA (3+2)"
" G54 = stred cela pri A0, G55 = stred boku pri A-90"
" After tilting to A-90 the hub axis lies along Y; Z0 of G55 is on D100."
N10  G54 G17 G90 G94 G40
N20  T31 M06                        "Freza D16"
N30  S2200 M03
N40  G00 Z250
N50  A0 C0
N60  X0 Y-65 M08
N70  Z2

"--- celo: mezikruzi D70 az D100 pod rovinu, dva prstence ---"
N80  G01 Z-1.5 F500
N90  Y-47 F450
N100 G02 X0 Y-47 I0 J47
N110 G01 Y-38
N120 G02 X0 Y-38 I0 J38
N130 G00 Z150 M09

"--- boky: sklopit, sest otvoru D10 po 60 stupnich ---"
N140 T32 M06                        "Vrtak D10"
N150 S1100 M03
N160 G55 G00 A-90
N170 X0 Y0 M08
N180 Z5
N190 G71 L100
N200 G91 C60
N210 G73 L190 Q5
N220 G90 G00 Z100 M09

"--- obvodova drazka: nastroj stoji, otaci se jen osa C ---"
N230 T33 M06                        "Freza D6"
N240 S4200 M03
N250 G00 X0 Y-22 C0 M08
N260 Z2
N270 G01 Z-1 F150
N280 G91 C360 F720                  "stupne za minutu"
N290 Z-1 F100
N300 C-360 F720
N310 G90 G00 Z100 M09
N320 G54 G00 A0 C0
N330 X0 Y300 Z250 M05
N340 M30

"--- L100: otvor se dvema vynorenimi ---"
N1000 G79 L100
N1010 G90 G01 Z-8 F140
N1020 G00 Z1
N1030 Z-7.5
N1040 G01 Z-16
N1050 G00 Z1
N1060 Z-15.5
N1070 G01 Z-24
N1080 G00 Z5 G70
*

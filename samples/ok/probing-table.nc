%4100 "DVA KUSY NA STOLE: ZAPIS POCATKU A KOREKCI"
" Hodnoty pocatku a korekci prepsal serizovac z mericiho protokolu."
" G92 zapisuje do tabulek (nic nejede), G93 ztotozni polohu nastroje."
N10  G17 G90 G94 G40 G34

"--- Tabulka pocatku ---"
N20  G92 G54 X150.25 Y200.1 Z-310.5    "levy sverak"
N30  G92 G55 X450.3 Y199.95 Z-310.42   "pravy sverak"
N40  G92 G57 X0 Y0 Z-180               "odkladaci poloha"

"--- Tabulka korekci: D1, D2 freza D10, D11 vrtak ---"
N50  G92 D1 X5.2 Z120.35               "hrubovani, pridavek 0.2"
N60  G92 D2 X5 Z120.35                 "nacisto"
N70  G92 D11 X4.25 Z98.4

"--- Freza D10: kapsa v levem a pravem sveraku ---"
N80  G54 T1 M06
N90  D1 &0010                          "delkova korekce do osy Z"
N100 S2800 M03
N110 G00 X0 Y0
N120 Z50 M08
N130 G71 L100
N140 G55 G00 X0 Y0                     "pravy sverak"
N150 G71 L100

"--- Totez nacisto, poloha se meni i pod jinou korekci ---"
N160 D2 G00 Z50
N170 G71 L100
N180 G54 G00 X0 Y0
N190 G71 L100

"--- Oblouk drazky vpravo a jeho zrcadlovy obraz vlevo ---"
N200 G00 X60 Y0
N210 G71 L200
N220 G35 X-1                           "zrcadlit X"
N230 G00 X60 Y0
N240 G71 L200
N250 G34                               "konec zrcadleni"

"--- Sikma ploska: prostorova transformace, vrtani kolmo ---"
N260 G00 Z80 M09
N270 T2 M06
N280 D11 S1100 M03
N290 G31 X40 Y0 Z-5 A0 B30 C0          "natoceni o 30 stupnu kolem Y"
N300 G00 X0 Y0 M08
N310 Z3
N320 G01 Z-14 F120
N330 G00 Z60 M09
N340 G34

"--- Jednorazovy posun do pripravku a najeti zpet ---"
N350 G58 G00 X0 Y-80                   "plati jen v tomto bloku"
N360 X0 Y0
N370 G57 G00 Z0 &0000                  "odlozit, bez delkove korekce"
N380 X0 Y0 M05
N390 M01                               "Vlozit dorazovy kolik"
N400 G93 G56 X0 Y0 Z25                 "kolik: X0 Y0, vyska 25"
N410 G00 Z125
N420 M30

"--- L100: kapsa 40 x 24, rohy R8, hloubka 5 ---"
N1000 G79 L100
N1010 G00 X0 Y0
N1020 Z2
N1030 G01 Z-5 F150
N1040 X10 F400                         "vybrat stred"
N1050 X-10
N1060 X0
N1070 G41 X12 Y-8
N1080 G03 X20 Y0 I0 J8                 "najezd po oblouku"
N1090 G01 Y4
N1100 G03 X12 Y12 I-8 J0
N1110 G01 X-12
N1120 G03 X-20 Y4 I0 J-8
N1130 G01 Y-4
N1140 G03 X-12 Y-12 I8 J0
N1150 G01 X12
N1160 G03 X20 Y-4 I0 J8
N1170 G01 Y0
N1180 G03 X12 Y8 I-8 J0
N1190 G01 G40 X0 Y0
N1200 G00 Z50 G70

"--- L200: drazka hloubky 3 od mista, kde nastroj stoji ---"
N1300 G79 L200
N1310 G00 Z2
N1320 G01 Z-3 F150
N1330 G03 X40 Y20 I-20 J0 F400
N1340 G01 Y30
N1350 G00 Z50 G70
*

%1200 "PRIRUBA 120 x 80 x 12"
" Material: ocel 11 523, vypalek 126 x 86, otvor predvrtan na D30"
" Nulovy bod G54: stred priruby, Z0 = horni plocha"
" D1 = polomer frezy + pridavek 0.3   D2 = polomer frezy nacisto"

N10  G54 G17 G90 G94 G40
N20  T1 M06                         "Freza valcova D16"
N30  S1200 M03
N40  G00 X-15 Y-75
N50  Z50 M08
N60  Z2

"--- Obvod hrubovat: 3 vrstvy po 4.2 mm ---"
N70  G01 Z0 F600 D1
N80  G71 L100 Q3
"--- Obvod nacisto: plna vyska, pak jeste vyjiskrit ---"
N90  S1500 D2
N100 G71 L110 Q2
N110 G00 Z2

"--- Stredovy otvor D50: 3 vrstvy hrubovat, 1 nacisto ---"
N120 X0 Y0 S1200
N130 G01 Z0 F600 D1
N140 G71 L200 Q3
N150 Z-8.4 S1500 D2
N160 G71 L200
N170 G00 Z100 M09

"--- Ctyri otvory D9 pro srouby ---"
N180 T2 M06                         "Vrtak D9"
N190 S900 M03
N200 G00 X45 Y25 M08
N210 Z2 G71 L300
N220 X-45 G71 L300
N230 Y-25 G71 L300
N240 X45 G71 L300
N250 Z100 M09
N260 X0 Y120 M05
N270 M30

"--- L100: jedna hrubovaci vrstva obvodu, nesousledne ---"
N1000 G79 L100
N1010 G00 X-15 Y-75
N1020 G91 G01 Z-4.2 F400
N1030 G90 G42 Y-55 F260
N1040 G02 X0 Y-40 I15 J0            "najezd po oblouku"
N1050 G01 X45
N1060 G03 X60 Y-25 I0 J15
N1070 G01 Y25
N1080 G03 X45 Y40 I-15 J0
N1090 G01 X-45
N1100 G03 X-60 Y25 I0 J-15
N1110 G01 Y-25
N1120 G03 X-45 Y-40 I15 J0
N1130 G01 X0
N1140 G02 X15 Y-55 I0 J-15          "vyjezd po oblouku"
N1150 G01 G40 Y-75 G70

"--- L110: obvod nacisto, sousledne ---"
N1200 G79 L110
N1210 G00 X15 Y-75
N1220 G01 G41 Y-55 F180
N1230 G03 X0 Y-40 I-15 J0
N1240 G01 X-45
N1250 G02 X-60 Y-25 I0 J15
N1260 G01 Y25
N1270 G02 X-45 Y40 I15 J0
N1280 G01 X45
N1290 G02 X60 Y25 I0 J-15
N1300 G01 Y-25
N1310 G02 X45 Y-40 I-15 J0
N1320 G01 X0
N1330 G03 X-15 Y-55 I0 J-15
N1340 G01 G40 Y-75 G70

"--- L200: jedna vrstva otvoru D50 ze stredu a zpet do stredu ---"
N1400 G79 L200
N1410 G91 G01 Z-4.2 F200
N1420 G90 G41 X10 Y-15 F260
N1430 G03 X25 Y0 I0 J15
N1440 X25 Y0 I-25 J0                "cely kruh"
N1450 X10 Y15 I-15 J0
N1460 G01 G40 X0 Y0 G70

"--- L300: jeden otvor s vynorenim po 7 mm ---"
N1500 G79 L300
N1510 G01 Z-7 F110
N1520 G00 Z2
N1530 Z-6.5
N1540 G01 Z-15.5
N1550 G00 Z2 G70
*

%2600 "VIKO LOZISKA: OTVOR D60 PO SROUBOVICI, LEDVINY"
" Material hlinik, tloustka 20 mm, nula G54 ve stredu, Z0 nahore"
" Upnuti: dve upinky ve smeru X, po otvoru se prepinaji (M00)"
N10  G54 G17 G90 G94 G40
N20  T3 M06                         "Freza D20, 3 brity"
N30  S3200 M03
N40  G00 X0 Y0
N50  Z50 M08
N60  Z2
N70  G01 Z0.5 F800

"--- Otvor D60: draha stredu frezy R20, stoupani 2 mm na otacku ---"
N80  G09 G01 X20 F900               "sroubovice"
N90  G91 G03 X0 Y0 Z-2 I-20 J0
N100 G73 L90 Q9                     "10 otacek, dno Z-19.5"
N110 Z-1 X0 Y0 I-20 J0              "prorezat na Z-20.5"
N120 X0 Y0 I-20 J0                  "vycistit dno"
N130 G90 G01 X0 G98                 "zpet do stredu, zaklad. stav"
N140 G00 Z100
N150 M00                            "Prepnout upinky do smeru Y!"
N160 /M01                           "Prvni kus: zmerit otvor"

"--- Dve ledviny sirky 10, stredni polomer 65, hloubka 6 ---"
N170 T4 M06                         "Freza D10"
N180 S4500 M03 M08
N190 G00 X60 Y25
N200 Z2 G71 L100
N210 X-60 Y-25 G71 L200
N220 Z100 M09
N230 /M01                           "Kontrola hloubky ledvin"

"--- Ctyri kapsicky D12 pro hlavy sroubu, celem nastroje ---"
N240 T5 M06                         "Zahlubnik D12 s vodicim cepem"
N250 S600 M03 M08
N260 G00 X50 Y-50
N270 Z2 G71 L300
N280 X-50 Y50 G71 L300
N290 Z150 M09
N300 X0 Y200 M05
N310 M30

"--- L100: prava horni ledvina, rampa po sroubovici tam a zpet ---"
N1000 G79 L100
N1010 G01 Z0 F300
N1020 G09 G91
N1030 G03 X-35 Y35 Z-1 I-60 J-25 F700
N1040 G02 X35 Y-35 Z-1 I-25 J-60
N1050 G73 L1030 Q2                  "3 x 2 mm"
N1060 G03 X-35 Y35 I-60 J-25        "rovne dno"
N1070 G04 Q20                       "0.2 s"
N1080 G90 G98 G00 Z2 G70

"--- L200: leva dolni ledvina ---"
N1100 G79 L200
N1110 G01 Z0 F300
N1120 G09 G91
N1130 G03 X35 Y-35 Z-1 I60 J25 F700
N1140 G02 X-35 Y35 Z-1 I25 J60
N1150 G73 L1130 Q2
N1160 G03 X35 Y-35 I60 J25
N1170 G04 Q20
N1180 G90 G98 G00 Z2 G70

"--- L300: zahloubeni s prodlevou na dne ---"
N1200 G79 L300
N1210 G01 Z-6.4 F60
N1220 G04 Q50                       "0.5 s, zacistit plochu"
N1230 G01 Z-6 F200
N1240 G00 Z2 G70
*

%1001 "DESKA 100 x 60 x 20, OBRYS A 4 DIRY"
"Material hlinik, upinky mimo obrys"
"G54: levy dolni roh, horni plocha"
N10 G54 G17 G90 G94 G40 G80 "vychozi stav, nic z minula"

"--- T1 FREZA D16, KOREKCE D1 ---"
N100 T1 M06
N110 S3200 M03 M08 "otacky a chlazeni"
N120 G00 X-30 Y-30 "najezd mimo material"
N130 Z5 D1 &0010 "delkova korekce v ose Z"
N140 G01 Z-20 F300
N150 G71 L100 "obrys: podprogram L100"
N160 G00 Z100 M09
N170 M05

"--- T2 VRTAK D8.5, KOREKCE D2 ---"
N200 T2 M06
N210 S1800 M03 M08
N220 G00 X20 Y15
N230 Z5 D2 "korekce vrtaku"
N240 R10=-25 R11=150 "hloubka a posuv pro L8100"
N250 G81 X20 Y15 "1. dira: G81 vola L8100"
N260 X80
N270 Y45
N280 X20
N290 G80 Z100 M09 "konec vrtani, vyjet"
N300 M30 "konec programu"

N1000 G79 L100 "OBRYS, Z X-30 Y-30"
N1010 G41 G01 X0 Y-20 F400 "nastroj vlevo, D1; primkou"
N1020 Y60
N1030 X90
N1040 G02 X100 Y50 I0 J-10 "roh R10, stred X90 Y50"
N1050 G01 Y0
N1060 X-20
N1070 G40 X-30 Y-30 "zrusit korekci primkou"
N1080 G70

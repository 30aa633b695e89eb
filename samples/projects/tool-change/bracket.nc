%7001 "KONZOLA 160 x 100: TRI NASTROJE, VYMENA PRES L9010"
N10  G17 G90 G94 G40 M61 M36        "dopravnik vpred, plny posuv"

"--- celni freza D63 ---"
N20  R60=1
N30  G72 L9010
N40  G54 G00 X-45 Y25
N50  Z50 S1000 M03 M08
N60  Z0
N70  G23 I1 G01 X205 F700
N80  Y75
N90  X-45
N100 G98 G00 Z50

"--- freza D20: obvodova drazka a vybrani ---"
N110 R60=2
N120 G72 L9010
N130 G54 G00 X30 Y50
N140 Z50 S1800 M03 M17
N150 Z2
N160 G01 Z-6 F200
N170 G23 I4 X60 F500                "jemna sada dynamiky"
N180 G02 X100 Y50 I20 J0
N190 G03 X130 Y50 I15 J0
N200 G98 G00 Z50

"--- vrtak D8 se snizenym posuvem pri zavrtani, pak cisteni ---"
N210 R60=3
N220 G72 L9010
N230 G54 G00 X15 Y15 M62            "dopravnik zpet: uvolnit trisky"
N240 Z3 S1400 M03 M08
N250 G71 L10
N260 X145 G71 L10
N270 Y85 G71 L10
N280 X15 G71 L10
N290 Z80 M63 M09                    "dopravnik stop"

"--- kontrola sondou a vymena palety ---"
N300 R60=24
N310 G72 L9010
N320 G54 G00 X80 Y50 M81            "sonda zapnuta"
N330 Z20
N340 G01 Z5 F300
N350 G04 Q100
N360 G00 Z80 M82
N370 M100                           "centralni mazani"
N380 M60                            "vymena palety: poloha neznama"
N390 G53 G00 Z0
N400 X0 Y500
N410 M30

"--- L10: dira s prodlevou ---"
N500 G79 L10
N510 G01 Z-1 F120
N520 Z-17 F180
N530 G04 Q15
N540 G00 Z3 G70
*

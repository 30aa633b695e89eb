%1250 "DRŽÁK LOŽISKA - srovnání èela a obvod"
" Soubor z editoru ve Windows (kódování Windows-1250), øádky CR LF"
" Nulový bod G54: levý pøední roh, Z0 = hotová horní plocha, rozmìr 90 x 60"

N10  G54 G17 G90 G94 G40
N20  T6 M06                         "èelní hlava prùmìr 50"
N30  S900 M03
N40  G00 X-30 Y15
N50  Z20 M08
N60  Z0
N70  G01 X120 F600                  "první pás"
N80  Y47                            "pøejezd o 32 mm"
N90  X-30                           "druhý pás"
N100 G00 Z100 M09
N110 T7 M06                         "válcová fréza prùmìr 20"
N120 S1100 M03
N130 X-30 Y-30 M08
N140 Z2
N150 G01 Z-12 F500 D7               "D7 = polomìr frézy"
N160 G41 X0 F220                    "souslednì, zleva nahoru"
N170 Y54
N180 G02 X6 Y60 I6 J0               "roh R6"
N190 G01 X84
N200 G02 X90 Y54 I0 J-6
N210 G01 Y6
N220 G02 X84 Y0 I-6 J0
N230 G01 X6
N240 G02 X0 Y6 I0 J6                "poslední roh, obvod uzavøen"
N250 G01 Y20                        "pøebìh pøes zaèátek"
N260 G40 X-30
N270 G00 Z100 M09
N280 X0 Y150 M05                    "hotovo, pøíští kus"
N290 M30
*

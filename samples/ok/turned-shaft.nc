%2210 "HRIDEL STUPNOVY D44 x 95, ZAVIT M24x2"
" Polotovar: tyc D50, ocel 12 050, vylozeni 120 mm, celo +1 mm"
" Nula G54: osa vretene, Z0 = hotove celo. X jsou prumery (G74),"
" I a J obloukovych bloku jsou polomery: I podel X, J podel Z."
" G19 je u tohoto systemu rovina ZX."
"   T1 D1 hrubovaci nuz      T3 D3 upichovaci 4 mm, leve ostri"
"   T2 D2 dokoncovaci nuz    T4 D4 zavitovy nuz 60 st."

N10 G54 G19 G74 G90 G95 G40
N20 G00 X140 Z180                   "bezpecna poloha"

"=== HRUBOVANI ==="
N30 T1 D1 M06
N40 M42 S900 M03
N50 G00 X54 Z0.2 M08
N60 G01 X-1.6 F0.2                  "zarovnat celo s pridavkem"
N70 G00 Z2
N80 X45
N90 G01 Z-95 F0.35                  "D45 v cele delce"
N100 X47
N110 G00 Z2
N120 X45
N130 G91 G00 X-3.5                  "triska 3.5 mm na prumer"
N140 G90 G01 Z-54                   "D41.5, 38, 34.5, 31"
N150 G91 X1
N160 G90 G00 Z2
N170 G91 X-1
N180 G73 L130 Q3
N190 X-3                            "D28 a D25 pro zavit"
N200 G90 G01 Z-27.8
N210 G91 X1
N220 G90 G00 Z2
N230 G91 X-1
N240 G73 L190 Q1
N250 G90 X140 Z180 M09

"=== NACISTO ==="
N260 T2 D2 M06
N270 M43 S1600 M03
N280 G96 G00 X28 Z0 M08             "konstantni rezna rychlost"
N290 G01 X-0.8 F140                 "celo, posuv v mm/min"
N300 G00 Z2
N310 G95 X16
N320 G42 G01 X20 Z0 F0.12
N330 X23.8 Z-1.9                    "srazeni pod zavit"
N340 Z-28
N350 X27
N360 G03 X30 Z-29.5 I0 J-1.5        "zaobleni hrany R1.5"
N370 G01 Z-53
N380 G02 X34 Z-55 I2 J0             "prechod R2"
N390 G01 X40
N400 G03 X44 Z-57 I0 J-2            "zaobleni hrany R2"
N410 G01 Z-94
N420 X52
N430 G40 G00 X56
N440 X140 Z180 M09

"=== ZAPICH 4 x 1.9 ==="
N450 T3 D3 M06
N460 M42 S500 M03
N470 G00 X34 Z-28 M08
N480 G01 X20 F0.06
N490 G04 Q30                        "prodleva 0.3 s, zacistit dno"
N500 G01 X34 F0.3
N510 G00 X140 Z180 M09

"=== ZAVIT M24x2 ==="
N520 T4 D4 M06
N530 M41 S400 M03
N540 G00 X30 Z8 M08
N550 X23.2 G71 L100
N560 X22.6 G71 L100
N570 X22.1 G71 L100
N580 X21.75 G71 L100
N590 X21.546 G71 L100
N600 X21.546 G71 L100               "vyjiskrit"
N610 X140 Z180 M09
N620 M05
N630 M30

"--- L100: jeden pruchod zavitu od prumeru, na kterem nuz stoji"
N1000 G79 L100
N1010 G33 Z-26 K2
N1020 G00 X30
N1030 Z8 G70
*

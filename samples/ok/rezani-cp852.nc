%2852 "üEZµNÖ DRµ¦EK KOTOU¬OVOU FRZOU - pı¡ruba Ÿerpadla"
" Vìkres 4-0852-17, materi l ocel 12 020, tlouçœka 16 mm"
" Nulovì bod G54: stıed pı¡ruby, Z0 = horn¡ plocha, polomØr pı¡ruby 60"
" N stroj T21: kotouŸov  fr‚za D80 x 4, vodorovn  hlava, osa kotouŸe v ose Y"

N10  G54 G17 G90 G94 G40
N20  T21 M06                        "£hlov  hlava, zkontrolovat natoŸen¡"
N30  S180 M03                       "vıeteno vpravo, ıezn  rychlost 45 m/min"
N40  G00 X-115 Y0
N50  Z100
N60  Z50 M17                        "chladic¡ kapalina 1 a 2"

" Tıi soubØ§n‚ dr §ky s rozteŸ¡ 24 mm, ka§d  na dva pr…chody"
N70  Y-24 G71 L100
N80  Y0   G71 L100
N90  Y24  G71 L100

" ZaŸiçtØn¡ prostıedn¡ dr §ky na ç¡ıku 4.2 mm"
N100 Y-0.1
N110 G01 Z34 F400
N120 X115 F140
N130 Y0.1
N140 X-115
N150 G00 Z100 M09                   "vypnout chlazen¡"
N160 /M01                           "prvn¡ kus: zmØıit ç¡ıku dr §ky"
N170 X-200 Y150 M05                 "odjezd k vìmØnØ obrobku"
N180 M30

" L100: jedna dr §ka, hloubka 3 a 6 mm (stıed kotouŸe 37 a 34 nad plochou)"
N1000 G79 L100
N1010 G01 Z37 F400
N1020 X115 F110                     "nesouslednØ"
N1030 Z34
N1040 X-115 F160                    "zpØt naŸisto"
N1050 G00 Z50 G70
*

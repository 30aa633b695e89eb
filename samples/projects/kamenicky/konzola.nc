%895 "KONZOLA - vrt†n° a zahlouben°, k¢d Kamenickòch"
" Program ze star®°ho editoru: h†áky a á†rky v k¢du KEYBCS2 (CP895)"
" P©°li® ëluüouákò kñ§ £pàl É†belskÇ ¢dy - zkou®ka v®ech p°smen"
" PûãLIõ íLUÜOUÄKù K¶• óPâL ÖèBELSKê ïDY"

N10  G54 G17 G90 G94
N20  T1 M06                         "st©edic° vrt†k"
N30  S1800 M03 M08                  "v©eteno vpravo, chlazen°"
N40  G00 X15 Y15
N50  Z5
N60  G71 L10                        "levò p©edn° otvor"
N70  X85 G71 L10                    "pravò p©edn°"
N80  Y65 G71 L10                    "pravò zadn°"
N90  X15 G71 L10                    "levò zadn°"
N100 Z100 M09
N110 T2 M06                         "vrt†k prñmàr 6.6"
N120 S1400 M03 M08
N130 Y15 X15
N140 Z3
N150 G71 L20
N160 X85 G71 L20
N170 Y65 G71 L20
N180 X15 G71 L20
N190 Z150 M09                       "nahoru, kapalinu vypnout"
N200 X0 Y200 M05                    "stñl dop©edu, vymànit obrobek"
N210 M30

" L10: navrt†n° pro ®roub M6"
N500 G79 L10
N510 G01 Z-3.5 F150
N520 G04 Q20                        "prodleva 0.2 s"
N530 G00 Z5 G70

" L20: prñchoz° otvor, tlou®üka 12 mm, jeden vòplach t©°sek"
N600 G79 L20
N610 G01 Z-7 F140
N620 G00 Z3
N630 Z-6.5
N640 G01 Z-15
N650 G00 Z3 G70
*

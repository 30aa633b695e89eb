%5001 "KAPSA 80 x 50 x 12 RADKOVANIM, FREZA D12"
" Zadani:  R10 delka X   R11 sirka Y   R12 hloubka   R13 hloubka trisky
"          R14 prumer frezy   R15 pridavek na stenu
" Vypocet: R20 draha v X   R21 draha v Y   R22 krok v Y   R23 opakovani
"          R24 opakovani vrstev   R25, R26 pulky drah   R27 pul trisky
" R90, R91 (odjezd a najezd v Z) jsou v tabulce parametru stroje.
N10  G54 G17 G90 G94 G40
N20  T2 M06                             "Freza D12, 2 brity"
N30  S2600 M03
N40  R10=80 R11=50 R12=12 R13=3 R14=12 R15=0.25
N50  R1=1 R2=2 R3=0.75                  "konstanty; 0.75 D je krok"

"R16 = D + 2 x pridavek, R20 = delka - R16, R21 = sirka - R16"
N60  G29 R5=3021517 R6=1141716 R7=2101620 R8=2111621
"R18 = 0.75 D, R22 = R21/R18 = pocet radku; na cele pary nahoru"
N70  G28 R5=3031418 R6=4211822 R7=4220219
N80  G28 R5=8190023 R6=1230119 R7=3190219
"R22 = krok v Y; R24 = hloubka / triska - 1"
N90  G28 R5=4211922 R6=4121324 R7=2240124
"polovicni drahy pro vychozi roh, pul trisky pro rampu"
N100 G28 R5=4200225 R6=4210226 R7=4130227

N110 G00 X-R25 Y-R26
N120 ZR90 M08
N130 ZR91
N140 G01 Z0 F800

"--- vrstva: rampa tam a zpet, pak radky po dvojicich ---"
N150 G91 G01 X25 Z-R27 F250
N160 X-25 Z-R27
N170 XR20 F500
N180 YR22
N190 X-R20
N200 YR22
N210 G73 L170 QR23
N220 XR20                               "posledni radek"
N230 X-R20 Y-R21 F1500                  "zpet do vychoziho rohu"
N240 G73 L150 QR24

"--- steny nacisto: obvod v plne hloubce, roh = polomer frezy ---"
N250 R28=R15 R29=R20 R30=R21
N260 G28 R5=3021531 R6=1293129 R7=1303130  "drahy + 2 x pridavek"
N270 X-R28 Y-R28 F300 S3200
N280 XR29 F420
N290 YR30
N300 X-R29
N310 Y-R30
N320 G04 Q10
N330 XR28 YR28 F1000                    "od steny"
N340 G90 G00 ZR90 M09
N350 X0 Y150 M05
N360 M30
*

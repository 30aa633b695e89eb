%5002 "SEST KRUHOVYCH KAPES D40 x 8, FREZA D10 (4 UROVNE SKOKU)"
" rady R31 > sloupce R30 > vrstvy > prstence R33"
N10  G54 G17 G90 G94 G40
N20  T3 M06                             "Freza D10 s celnim ostrim"
N30  S3000 M03 M08
N40  G00 X-60 Y-30
N50  ZR90
     "hloubka kapsy R40 a trisky R41"
N60  R31=-30 R34=5 R35=60 R36=60 R37=2 R1=1 R40=8 R41=2
N65  G27 R5=-4404142 R6=-2420142        "cele cislo: R42 = R40/R41 - 1"

N70  R30=-60                            "--- nova rada ---"
N80  G90 G00 XR30 YR31                  "--- nova kapsa ---"
N90  ZR91
N100 G01 Z0 F800
N110 G91 Z-R41 F90 R33=0                "--- nova vrstva ---"
N120 G26 R5=1333433                     "polomer prstence R33 = R33 + 5"
N130 G01 XR34 F350
N140 G03 I-R33 J0                       "cely kruh v rovine XY"
N150 G73 L120 QR37                      "3 prstence: 5, 10, 15"
N160 G01 X-R33 F900                     "zpet do stredu"
N170 G73 L110 QR42                      "4 vrstvy po 2 mm"
N180 G90 G00 ZR91
N190 G26 R5=1303530
N200 G73 L80 Q2                         "3 kapsy v rade"
N210 G26 R5=1313631
N220 G73 L70 Q1                         "2 rady"

N230 ZR90 M09
N240 X0 Y150 M05
N250 M30
*

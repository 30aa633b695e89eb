KOVO-MODEL BRNO            vykres 3-1147-02   list 1/1
Drzak cidla, 20 kusu. Tento text pred znakem procenta system necte
a muze byt i delsi nez osmdesat znaku, protoze program zacina az cislem za procentem.
  %3300 "DRZAK CIDLA"   "druhy komentar uz neni nazev"
"komentar pred prvnim blokem

N10 G54 G17
    G90 G94        "komentar uprostred bloku"
    G40
N20 T12 M06   N30 S1800 M3 "vreteno" N40 G0 X 0 Y 0
"komentar na zacatku radku, blok N40 pokracuje:" Z50
N50 Z2. M8 N60 G1 Z-3
    F   150
"-----------------------------------------
N70 "drazka" X+40 F 320 "konec rovne casti
N80
    G3
    X50 Y10
    I0  J10
N90 G1 Y 27.5 N100 G2 X62.5
    "osy a stredy mohou stat v libovolnem poradi"
    I12.5 Y40
N110 G1 X 80. N120 Y.5 "pul milimetru" N130 Y-0.25 N140 X0 N150 Y0
N160 G0 Z 50 M9 N170 "jen komentar, takovy blok se zachova"
N0180 / M1 "mereni; pri zapnutem vynechavani bloku se nezastavi"
N190 G71 L9 Q2 N200 G0
	X0		Y100   "mezi slovy smi byt i tabelatory"
N210 M5 N220 "pred koncem" M30
""
N900 G79 "ofuk trisek" L 9   "i tady smi byt komentar"
N910 M50 N920 G04 Q 150 "1.5 s"
N930 M53 G70
* " za hvezdickou smi stat uz jen komentare
"konec vypisu"

%4711 "DRZAK: DVA NASTROJE"
N10  G54 G90 G00 X0 Y0 Z100
N20  T12 M06                   "freza D20"
N30  G54 G00 X-15 Y0
N40  S1500 M03 M08
N50  Z2
N60  G01 Z-5 F200
N70  X80 F600
N80  G00 Z100 M09
N90  M05 M92                   "ofuk pred vymenou"
N100 T7 M06                    "vrtak D8"
N110 M93                       "ofuk vypnout"
N120 G00 X20 Y30
N130 S3000 M03
N140 Z2 M08
N150 G01 Z-18 F250
N160 G04 Q50
N170 G00 Z100
N180 M00                       "kontrola rozmeru"
N190 M30

%22 "BLK-2 words before the first N" / "BLK-6 a slash too"
"                                    ^ E0203
 S800 "here" M3
 X-5.5
N10 G90 G0 X0 Y0
N20 M30

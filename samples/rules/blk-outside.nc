%22 "BLK-2 words before the first N" / "BLK-6 a slash too"
"                                    ^ E0203
 S800 "here" M3
"^^^^ E0203
"            ^^ E0203
 X-5.5
"^^^^^ E0203
N10 G90 G0 X0 Y0
N20 M30

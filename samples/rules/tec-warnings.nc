%159 "TEC-7 each once in a program
N10 G90 G0 X0 Y0 M6
"                ^^ W0620
N20 G1 G41 X10 F100
"      ^^^ W0618
"   ^^ W0619
N30 G42 X20 M6
"   ^^^ W0624
"           ^^ W0625
N40 G40 X30 S500 M3
N50 X40
N60 M5
N70 X50 "once
N80 M30

%219 "Preskocitelny konec
"BLK-10 a slash in a block that gives the program its structure
N10 G90 G0 X0 Y0
N20 G71 L100
N30 / M30
"   ^ W0219
N100 G79 L100
N110 G0 X5
N120 G70 /
"        ^ W0219

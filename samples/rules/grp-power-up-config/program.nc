%115 "GRP-3 G01 and G91 from the project file
N10 X10
"   ^^^ W0601
"   ^^^ W0605
N20 G90 Y0
N30 M30

%311 "BLK-11 nothing is divided"
N10 G90 G0 X0 Y0 Z50 F100
N20 G1 Z-24/2 X25/2
"      ^^^^^^ E0106
"             ^^^^^ E0106
N30 R10/2
"   ^^^^^ E0106
N40 XR10/2
"   ^^^^^^ E0106
N50/2 G0 Y5
"   a block skip
N60 G91/1 X5
"   ^^^^^ E0106
N65 /1 Y1
N70 M30

%203 "BLK-2 a program with no N at all has this one error, and no E0205
 G90 G0 X0 Y0
"^^^ E0203
G1 X10 F200
X20
M30

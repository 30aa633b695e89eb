%137 "MFN-9 the speed and the gear after the block
N10 G90 G0 X0 Y0
N20 M41 "no S yet"
N30 S20
N40 S500 M3
N50 S501
"   ^^^^ E0607
N60 S19
"   ^^^ E0607
N70 M42 S2000
N80 M41
"   ^^^ E0607
N90 G0 X5 "neither S nor M41 to M44 is written"
N100 M40 S9999
"        ^^^^^ W0617
N110 S10 M42
"    ^^^ E0607
N120 M40
"    ^^^ W0617
N130 S5
"    ^^ W0617
N131 S0 "turns in no gear"
N132 G96
N134 S7000 "what S means here is in no source"
N136 G94 S50
N140 M30

%6 "LEX-4 runs of letters before a number: one finding, the word is not known
N10 G0 G90 Y0 řX5
"             ^ E0101
N20 XRR5=1
"    ^ E0103
N30 RRX5
"   ^ E0103
N40 XYZ5
"   ^ E0103
N50 X99999999.5 Y-99999999.5 Z-99999999999
"    ^^^^^^^^^^ E0302
"                ^^^^^^^^^^^ E0302
"                             ^^^^^^^^^^^^ E0302
N60 X... R10=...
"   ^^^^ E0106
"        ^^^^^^^ E0106
N70 X5- Y+1
"   ^^^ E0106
N80 M30

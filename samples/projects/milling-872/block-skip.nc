%25 "NEPOVINNE BLOKY A POZNAMKY"
" Bloky s lomitkem se pri zapnutem vypousteni neprovedou"
N10 G54 G17 G90 G94
N20 T4 D4 M06
N30 S800 M03
N40 G00 X0 Y0 Z10
N50 /G01 Z-1 F60     "srazeni jen u prvniho kusu"
N60 /G00 Z10
N70 X25
N80 G01 Z-12 F90
N90 G00 Z10 M05
N100 M30

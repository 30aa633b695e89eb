%1 "mezi bloky na jednom radku chybi N"
N10 G54 G90 G00 X0 Y0 Z50
N20 T1 M06 30 S1200 M03
"      ^^^^^^ E0102
N40 G01 Z-2 F300
N50 X20
N60 G00 Z50
N70 M30

%70 "PRG-6 case, leading zeros and five extensions do not matter
N10 G90 G0 X0 Y0
N20 G72 L9071
N30 G72 L9072
N40 G72 L9073
N50 G72 L9074
N60 G72 L75
N70 G72 L09071
N80 G72 L9076 "L9076.mac is none of them"
"        ^^^^ E0405
N90 M30

%7 "LEX-3 a word with a finding about its form gets no other
X1 5
"@ 2:1-2:5 E0102
N10 G90 G0 X0 Y0
N20 X1O0000
"   ^^^^^^^ E0107
N30 L1O
"   ^^^ E0107
N40 Q1O
"   ^^^ E0107
N50 T-O5
"   ^^^^ E0107
N60 M30

%307 "G jedne skupiny v bloku
"GRP-1 two functions of one group
N10 G90 G0 G1 X10 F100
"          ^^ E0307
N20 G90 G91 X5
"       ^^^ E0307
N30 G1 G1 Y5
"      ^^ E0307
N40 G17 G18
"       ^^^ E0307
N50 G4 Q50 G74
"          ^^^ E0307
N60 G41 G40 X0
"       ^^^ E0307
N70 M30

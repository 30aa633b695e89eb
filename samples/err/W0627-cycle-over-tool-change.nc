%634 "a tool change under a cycle"
"TEC-10 none after G80, nor with it
N10 G0 X0 Y0 Z5 F100 T1
N20 G81 X10
"   ^^^ W0612
N30 M6
"   ^^ W0627
N40 G80 M6
N50 M6
N60 M30

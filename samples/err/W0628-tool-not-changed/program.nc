%628 "T without M06"
"TEC-4 T only names the tool; M06 in the same block or a later one changes it
N10 G54 G90 T1
N20 M06
N30 T2 G00 X0 Y0
N40 T3 M06
N50 T4
"   ^^ W0628
N60 G00 X10
N70 M30

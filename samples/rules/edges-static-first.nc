%194 "with a finding that is an error the program is not executed
N10 G91 X5
N20 G1 X10
N40 XR1
N50 G1 Y5 Y6
"         ^^ E0306
N60 M30

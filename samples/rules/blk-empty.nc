"@ 7:1-7:4 W0214
"@ 8:1-8:4 W0214
"@ 8:5-8:8 W0214
"@ 13:1-13:4 W0214
%25 "BLK-5 a number alone is legal
N10 G90 G0 X0 Y0
N20
N30 N40
N50 /
N60 / 5
N70 "a comment
N80 ""
N90
"a comment on a line of its own belongs to the next block, BLK-9
N100
N105 X5
N110 M30

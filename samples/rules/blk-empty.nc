"@ 6:1-6:4 W0214
"@ 7:1-7:4 W0214
"@ 7:5-7:8 W0214
%25 "BLK-5 a number alone is legal
N10 G90 G0 X0 Y0
N20
N30 N40
N50 /
N60 / 5
N70 "a comment
N80 ""
N90
"a comment on the next line
N100 X5
N110 M30

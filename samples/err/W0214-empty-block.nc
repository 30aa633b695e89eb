"@ 7:1-7:4 W0214
"@ 9:1-9:4 W0214
"@ 9:5-9:8 W0214
%214 "Prazdne bloky
"BLK-5 a number only is legal; a comment or a slash silences the warning
N10 G90 G0 X0 Y0
N20
N30 G0 X5
N40 N50 N60 /
N70 "vyvrtano"
N80 M30

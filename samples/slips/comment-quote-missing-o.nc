%1 "uvozovka pred komentarem na o
N10 G54 G90 G0 X0 Y0 Z50
N20 T1 M6
N30 S1200 M3
N40 G4 Q500otvor 3x"
"          ^^^^^^^^ E0111
N50 G1 Y20 F300
N90 M30

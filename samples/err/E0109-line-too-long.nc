"@ 7:81-7:82 E0109
"@ 9:81-9:82 E0109
"@ 10:81-10:82 E0109
%109 "Dlouhe radky
"LEX-7 the 81st character is the first too many
N10 G90 G17
N20 G0 X0 Y0 Z100 "najeti nad obrobek, upinky jsou na rozich i vzadu xxxxxxxxxxxx
N30 G0 X5 "prave osmdesat znaku, to je jeste v poradku xxxxxxxxxxxxxxxxxxxxxxxxx
N40 G0 Y5                                                                      X5
"komentar na samostatnem radku xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx"
N50 M30

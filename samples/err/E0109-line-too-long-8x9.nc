"@ 5:81-5:82 E0109
"! dialect=cnc8x9
%1091 "Dlouhy radek na CNC8x9
N10 G90 G17
N20 G0 X0 Y0 Z100 "najeti nad obrobek, upinky jsou na rozich i vzadu xxxxxxxxxxxx
N30 M30

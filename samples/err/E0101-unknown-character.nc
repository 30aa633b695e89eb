%101 "Deska se čtyřmi otvory
"LEX-13 outside comments the text is ASCII, and not every ASCII character
N10 G90 G0 X0 Y0 S800 M3;
"                       ^ E0101
N20 G1 X50 F200 #
"               ^ E0101
N30 Y40 ?? M8 !
"       ^^ E0101
"             ^ E0101
N40 X0 é
"      ^ E0101
N50 Y0 "znaky ; # ? é v komentari nevadi"
N60 ;$@ G0 X-5
"   ^^^ E0101
N70 M30;
"      ^ E0101

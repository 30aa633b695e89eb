%105 “Deska 60x40”
"    ^ E0105
"LEX-12 quotes as a word processor writes them: one finding a comment
N10 G90 G0 X0 Y0 „najeti nad obrobek
"                ^ E0105
N20 S800 M3 “vreteno" G1 X10 F200
"           ^ E0105
N30 G0 Z50 "tady ” uz je jen text komentare"
N40 M30

%112 "Zapomenute uvozovky
"LEX-6 LEX-13 text outside a comment, one finding for all its words
N10 G90 G0 X0 Y0 Z50 VYCHOZI POLOHA
"                    ^^^^^^^^^^^^^^ E0111
N20 T1 M06 Freza valcova D16"
"          ^^^^^^^^^^^^^^^^^ E0111
N30 CYCLE 81 X5
"   ^^^^^^^^ E0111
N40 GOTO 140
"   ^^^^^^^^ E0111
N50 T2 M06 vrták průměr 9
"          ^^^^^^^^^^^^^^ E0101
N60 M30

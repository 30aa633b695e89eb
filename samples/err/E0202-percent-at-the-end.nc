%203 "Procento na konci, jak je zvykem jinde
"LEX-1 a second percent sign outside a comment
N10 G90 G0 X0 Y0
N20 M30
%
"@ 5:1-5:2 E0202

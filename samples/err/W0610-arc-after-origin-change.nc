%610 "Oblouk hned po zmene pocatku
"MOT-8 the programmed start is not where the tool stands
N10 G90 G0 X0 Y0
N20 G54
N30 G2 X20 Y0 I10 F200
"   ^^ W0610
N40 G2 X0 Y0 I-10
N50 G55 G0 X0 Y0
N60 G2 X20 Y0 I10
N70 M30

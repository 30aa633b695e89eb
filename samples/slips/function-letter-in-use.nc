%203 "G9l can be no G91 beside a G91, and is offered nothing
N10 G90 G00 X0
N20 G91 G9l X6
"       ^^^ E0107
N30 M30

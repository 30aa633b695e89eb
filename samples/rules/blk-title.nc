%21
"BLK-9 the title may stand on its own line
"BLK-2 comments between the program word and the first block are fine
N10 G90 G0 X0 Y0
N20 "BLK-9 this comment belongs to N20, so it is not called empty"
N30
"so does this one to N30
N40 X5
N50 M30

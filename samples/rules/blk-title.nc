%21
"BLK-9 the title may stand on its own line
"BLK-2 comments between the program word and the first block are fine
N10 G90 G0 X0 Y0
N20 "BLK-9 this comment belongs to N20, so it is not called empty"
N30
"@ 6:1-6:4 W0214
"a comment on a line of its own belongs to the next block
N40
N45 M30
"behind the last block all belong to it

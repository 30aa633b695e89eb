%26 "BLK-6 a slash after the block number makes the block skippable
N10 / G90 G0 X0 Y0
N20 G0 X5 /
N30 X6 / Y6
N35 Y7
 / N40 X7
"^ W0213
N50 X8 /N60 X9
"      ^ W0213
N70 X10
 / Y11
"^ W0213
N80 X12 "a comment between them" / "counts for nothing" Y12
N90 X13
"a comment is no word" / Y13
"                      ^ W0213
N100 X14 / "nor is this" N110 X15
"        ^ W0213
N120 M30

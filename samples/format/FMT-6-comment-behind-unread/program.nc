%1
N10  X1
N20  X5 ^^

N30 Y5 "a comment that does not fit behind the words of its block, however it is laid out"
N40 M30

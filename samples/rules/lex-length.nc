"@ 7:81-7:82 E0109
"@ 8:81-8:82 E0109
"@ 9:81-9:82 E0109
"LEX-7 a line before the start may be as long as it likes: xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx
%1011 "LEX-7 eighty characters are in order
N10 G90 G0 X0 "eighty xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx
N20 X5 "eighty-one xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx
N30 Y5                                                                         X1
N40	Y6																																																																									X1
N50 M30                                                                        * "LEX-7 measures up to the asterisk, no farther
"LEX-9 comments after it are in order, however long xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx
